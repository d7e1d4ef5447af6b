#pragma once
#include "lib/box.hpp"
#include <vector>
namespace bad {
struct Own { long double* p; };
struct A { lib::Box<int*> box; };
struct B { std::vector<lib::Grid<lib::Locked, 3>> grids; };
struct C { lib::Deep deep; lib::Box<Own> own; };
struct D { lib::Mid mid; };
struct E : lib::Mid { int fine; };
using Alias = lib::Box<lib::Base>;
struct F { Alias alias; Alias more[2]; };
struct G { struct { lib::Box<int&> ref; } inner; struct { int* q; }; };
template <class T> struct Own2 { T t; const char* s; };
struct H { Own2<int> own; Own2<double> other; };
}
