#pragma once
#include <array>
#include <string>
#include <vector>
namespace demo {
struct Point { double x, y; };
struct Path {
    double joints[6];
    char label[16];
    std::array<float, 3> axis;
    Point corners[4];
    std::vector<std::string> names[2];
    std::vector<Point> points;
    std::vector<std::vector<double>> rows;
};
}
