#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "library.hpp"

namespace demo {

using Ring = library::Ring<double>;
typedef library::Angle Angle;

/// The user's own class, with an adapter.
struct Robot {
    library::Pose pose;
    library::Angle angles[2];
    std::vector<library::Pose> path;
    std::optional<library::Angle> goal;
    std::map<std::string, library::Square> squares;
    library::Ring<double> ring;
    library::Ring<library::Pose> poses;
    library::Ring<int, 3> three;
    library::Ring<std::string, 2> words;
    library::Mask mask;
    library::Grid<2> grid;
    char before;
    library::Square square;
};

struct Turned : library::Angle {
    int count;
};

}  // namespace demo
