#pragma once
#include <cstdint>
#include <string>
namespace enum_and_nested {
enum class Mode : std::uint8_t { Idle /** nothing moves */, Busy };
struct State {
    struct Part { bool ok; std::string text; };
    using Piece = Part;
    Mode mode;
    Part part;
};
typedef State Condition;
using Latest = Condition;
using Activity = Mode;
}
typedef enum_and_nested::State EnumAndNestedState;
