#pragma once
#include <span>
#include <string>
#include <string_view>
#include <variant>
// Cases 07, 08, 28 and 63 of the type matrix.
namespace bad {
struct Views {
    std::string_view text;
    std::span<const double> numbers;
    std::u16string wide;
    std::variant<int, double, int> twice;
};
}
