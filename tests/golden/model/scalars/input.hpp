#pragma once
#include <cstdint>
namespace demo {
struct Scalars {
    bool flag;
    char letter;
    signed char small;
    unsigned char byte;
    std::int16_t i16;
    std::uint16_t u16;
    std::int32_t i32;
    std::uint32_t u32;
    std::int64_t i64;
    std::uint64_t u64;
    long long other64;
    float single;
    double twice;
};
}
