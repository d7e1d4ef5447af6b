#ifndef SHAPES_SHAPES_HPP
#define SHAPES_SHAPES_HPP

/// Types of the package shapes. typegen makes every struct and enum here usable on ports and as properties:
/// public fields of numbers, strings, vectors, fixed arrays, enums and other such structs.

#include <vector>

struct ShapesData {
    std::vector<double> samples;
};

#endif
