#pragma once
#include <cstddef>
#include <vector>
// Case 84 of the type matrix: the type registry calls std::byte "/byte".
struct byte { int value; };
struct Message { std::vector<std::byte> data; byte own; };
