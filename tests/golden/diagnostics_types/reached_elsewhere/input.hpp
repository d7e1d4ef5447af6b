#pragma once
#include "library/matrix.hpp"
#include <vector>
namespace bad {
struct Robot {
    library::Frame frame;
    std::vector<library::Matrix> history;
    int fine = 0;
};
struct Derived : library::Frame {};
}
