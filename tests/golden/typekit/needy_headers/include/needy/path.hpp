#pragma once
#include <vector>
namespace needy {
struct Point;
// Any use of it needs point.hpp, which comes later in the list.
struct Path {
    std::vector<Point> points;
};
}
