#pragma once
namespace demo {
template <class T, int N> struct Vec { T v[N]; };
template <class T> struct Unused { T* p; };
template <> struct Unused<int> { int* p; };  // a specialisation nobody's field uses
using Vec3 = Vec<double, 3>;
struct Pose { Vec3 position; Vec<float, 4> rotation; };
}
