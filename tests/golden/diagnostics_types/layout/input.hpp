#pragma once
namespace bad {
struct Tag {};
struct __attribute__((packed)) Packed { char head; double value; char tail; };
struct Shares { [[no_unique_address]] Tag tag; int x; };
}
