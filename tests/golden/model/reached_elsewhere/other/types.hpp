#pragma once
#include <vector>
namespace other {
enum Kind { A, B };
struct Point { double x; };
struct NotReached { int* p; };
}
