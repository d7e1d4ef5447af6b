#pragma once
namespace template_instance {
template <class T, int N> struct Vec { T v[N]; };
struct Pose { Vec<double, 3> position; };
}
