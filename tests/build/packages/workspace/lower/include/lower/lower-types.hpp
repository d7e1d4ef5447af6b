#pragma once
#include <vector>
namespace lower { struct Sample { std::vector<double> values; int number; }; }
