#pragma once
#include <vector>
namespace template_instance {
template <class T, int N> struct Vec { T v[N]; };
struct Pose { Vec<double, 3> position; std::vector<Vec<float, 2>> path; };
}
