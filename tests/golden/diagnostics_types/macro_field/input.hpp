#pragma once
#define FIELD(type, name) type name;
namespace bad {
struct Made { FIELD(int, fine) FIELD(int*, pointer) };
}
