#pragma once
#include <string>
#include <vector>
namespace greenhouse {
struct Climate { double temperature; };
enum class Mode { idle, heat, vent };
enum Side { left, right };
using Climates = std::vector<Climate>;
template <class T> struct Timed { T value; };
class Filter { double state_; };
struct Base { virtual ~Base(); };
namespace plants { struct Tomato { int leaves; }; }
}
