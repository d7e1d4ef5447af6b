#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
// Cases 01 to 03, 05, 10 to 12 and 91 of the type matrix.
namespace odd_numbers {
enum class Big : std::uint64_t { None = 0, All = std::numeric_limits<std::uint64_t>::max() };
enum class Small : std::int8_t { Least = -128, Most = 127, Max = 127 };
enum Flags : unsigned { kRead = 1, kWrite = 2, kBoth = 3, kHigh = 0x80000000u };
struct Numbers {
    long double precise;
    wchar_t letter;
    char16_t unit;
    char32_t code;
    std::byte raw;
    std::size_t size;
    std::ptrdiff_t distance;
    signed char tiny;
    unsigned char byte;
    char sign;
    Big big;
    Small small;
    Flags flags;
    enum { kOne, kTwo } choice;
    enum { kLow, kHigh, kHighest = 3 } level : 2;
};
}
