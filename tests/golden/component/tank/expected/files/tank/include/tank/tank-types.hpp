#ifndef TANK_TANK_TYPES_HPP
#define TANK_TANK_TYPES_HPP

/// Types of the package tank. typegen makes every struct and enum here usable on ports and as properties:
/// public fields of numbers, strings, vectors, fixed arrays, enums and other such structs.

namespace tank {

struct LevelSample {
    double value = 0;
};

}  // namespace tank

#endif
