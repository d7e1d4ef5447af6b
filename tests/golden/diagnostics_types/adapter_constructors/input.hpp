#pragma once

namespace library {

struct Vector {
    Vector() = default;
    Vector(double a, double b) : x(a), y(b) {}
    static Vector zero(int) { return Vector(); }
    Vector one() const { return Vector(1, 1); }
    static const char* text() { return ""; }
    double x = 0, y = 0;
};

struct Angle {
    double value = 0;
};

struct Good {
    static Good zero() { return {}; }
    double value = 0;
};

}  // namespace library

struct User {
    library::Vector vector;
    library::Angle angle;
    library::Good good;
};
