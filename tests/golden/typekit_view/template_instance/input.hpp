#pragma once
#include <vector>
namespace template_instance {
template <class T, int N> struct Vec { T v[N]; };
using Vec3 = Vec<double, 3>;
typedef Vec<double, 3> Position;
using Vec7 = Vec<short, 7>;
template struct Vec<int, 5>;
struct Pose { Vec<double, 3> position; std::vector<Vec<float, 2>> path; };
}
