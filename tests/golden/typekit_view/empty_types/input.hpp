#pragma once
namespace empty_types {
struct Tag {};
enum class Id : int {};
struct Holder { Tag tag; Id id; };
}
