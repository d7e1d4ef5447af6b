#pragma once
#include <cstdint>
#include <vector>
namespace demo {
enum Gaps { First = -3, Second, Third = 10 };
enum class Mode : std::uint8_t { Off, On, Active = On };  // two names for one value
enum class Extreme : std::uint64_t { Zero, Max = 18446744073709551615ULL };
enum class Low : std::int8_t { Min = -128, Max = 127 };
enum class Empty : int {};
enum { kCount = 4 };  // constants, not a type
enum class Late : short;
enum class Late : short { Now };
struct Motor {
    enum State { Stopped, Turning };
    State state;
    Mode mode;
    std::vector<Mode> history;
    Late late;
};
}
