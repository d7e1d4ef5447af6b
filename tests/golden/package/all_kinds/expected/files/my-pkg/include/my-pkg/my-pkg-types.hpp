#ifndef MY_PKG_MY_PKG_TYPES_HPP
#define MY_PKG_MY_PKG_TYPES_HPP

/// Types of the package my-pkg. typegen makes every struct and enum here usable on ports and as properties:
/// public fields of numbers, strings, vectors, fixed arrays, enums and other such structs.

#include <vector>

struct My_pkgData {
    std::vector<double> samples;
};

#endif
