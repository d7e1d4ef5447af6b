#pragma once
#include <cstdint>
#include <string>
namespace enum_and_nested {
enum class Mode : std::uint8_t { Idle /** nothing moves */, Busy };
struct State {
    struct Part { bool ok; std::string text; };
    Mode mode;
    Part part;
};
}
