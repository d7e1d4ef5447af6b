#pragma once
// Case 83 of the type matrix.
namespace bad {
struct Pose { double x, y; };
}
