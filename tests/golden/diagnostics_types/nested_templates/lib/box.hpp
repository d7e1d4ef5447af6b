#pragma once
namespace lib {
template <class T> struct Box { T content; int n; };
template <class T, int N> struct Grid { Box<T> cells[N]; };
struct Base { int* raw; };
struct Mid : Base { int y; };
class Locked { int secret; };
struct Deep { Grid<Locked, 3> grid; };
}
