#pragma once
// Case 58 of the type matrix, without an adapter.
namespace bad {
class Vector {
public:
    double operator()(int i) const { return values_[i]; }

private:
    double values_[3] = {};
};
struct Pose { Vector position; };
}
