#pragma once
#include <array>
#include <vector>
namespace bad {
struct Grid {
    double cells[3][4];
    std::array<std::array<double, 3>, 3> matrix;
    std::vector<std::array<int, 2>> pairs;
    std::vector<bool> bits;
    int open[0];
};
}
