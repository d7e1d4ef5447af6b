#ifndef MYPKG_MYPKG_TYPES_HPP
#define MYPKG_MYPKG_TYPES_HPP

/// Types of the package mypkg. typegen makes every struct and enum here usable on ports and as properties:
/// public fields of numbers, strings, vectors, fixed arrays, enums and other such structs.

#include <vector>

struct MypkgData {
    std::vector<double> samples;
};

#endif
