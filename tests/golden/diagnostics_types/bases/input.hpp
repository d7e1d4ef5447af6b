#pragma once
#include <vector>
namespace bad {
struct Plain { int a; };
struct Other { int a; };
struct Private : private Plain {};
struct Virtual : virtual Plain {};
struct Both : Plain, Other {};
struct Hides : Plain { double a; };
struct List : std::vector<int> {};
}
