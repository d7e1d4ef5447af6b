#pragma once
#include <vector>
/// In no namespace at all.
struct GoldenGlobal { std::vector<float> values; };
