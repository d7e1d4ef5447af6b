#pragma once
#ifndef WITH_EXTRA
#error "the option -DWITH_EXTRA=2 did not arrive"
#endif
#if __cplusplus < 202002L
#error "the option -std=c++20 did not arrive"
#endif
#include <sibling.hpp>
#define FIELD(type, name) type name;
namespace demo {
struct Made { FIELD(int, a) FIELD(double, b) Extra extra[WITH_EXTRA]; bool operator==(const Made&) const = default; };
}
