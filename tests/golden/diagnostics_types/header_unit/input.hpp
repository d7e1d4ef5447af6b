#pragma once
import "other.hpp";
// Case 88 of the type matrix.
namespace bad {
struct Fine { int x; };
}
