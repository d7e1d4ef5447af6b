#pragma once
#include <cstdint>
#include <string>
#include <vector>
namespace unnamed {
/// As headers of C have it: structs that are there for one field alone.
struct Outer {
    struct { float x, y; } pos;  ///< in m
    struct { std::int32_t a; std::string s; } v[3], w;
    struct { struct { std::vector<double> deep; } in; } two;
    struct { struct { int z; } within; };
    int n;
};
typedef struct { struct { double q[4]; } att; } CStyle;
template <class T> struct Box { struct { T value; } b; };
using IntBox = Box<int>;
}
