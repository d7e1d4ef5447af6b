#pragma once
#include <array>
#include <vector>
namespace sequences_and_arrays {
struct Point { double x, y; };
struct Path {
    std::vector<Point> points;
    std::vector<std::vector<double>> rows;
    std::array<short, 3> axis;
    char label[8];
    Point corners[2];
};
}
