#ifndef TYPES_TYPES_TYPES_HPP
#define TYPES_TYPES_TYPES_HPP

/// Types of the package types. typegen makes every struct and enum here usable on ports and as properties:
/// public fields of numbers, strings, vectors, fixed arrays, enums and other such structs.

#include <vector>

struct TypesData {
    std::vector<double> samples;
};

#endif
