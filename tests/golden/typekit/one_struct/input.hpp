#pragma once
namespace one_struct {
/// A level of a tank.
struct Level {
    double value = 0;  ///< how full @unit m
    int count = 0;
};
}
