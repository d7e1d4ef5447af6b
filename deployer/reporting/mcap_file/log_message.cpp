// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "log_message.hpp"

#include <string>

namespace OCL::recording {

oroforge::mcap::Schema logSchema(std::uint16_t id) {
    return {id, "rcl_interfaces/msg/Log", "ros2msg",
            "byte DEBUG=10\n"
            "byte INFO=20\n"
            "byte WARN=30\n"
            "byte ERROR=40\n"
            "byte FATAL=50\n"
            "builtin_interfaces/Time stamp\n"
            "uint8 level\n"
            "string name  # the module, component or thread\n"
            "string msg\n"
            "string file\n"
            "string function\n"
            "uint32 line\n" +
                std::string(80, '=') +
                "\n"
                "MSG: builtin_interfaces/Time\n"
                "int32 sec\n"
                "uint32 nanosec\n"};
}

oroforge::mcap::Channel logChannel(std::uint16_t id, std::uint16_t schema) {
    return {id, schema, "/rosout", "cdr", {{"oroforge.kind", "log"}}};
}

CdrText logMessage(std::uint64_t time, LogLevel level, std::string_view origin, std::string_view text) {
    constexpr std::uint64_t kSecond = 1000000000;
    CdrText message;
    message.number(static_cast<std::uint32_t>(time / kSecond)).number(static_cast<std::uint32_t>(time % kSecond));
    // The file, the function and the line are not known.
    message.byte(static_cast<std::uint8_t>(level)).text(origin).text(text).text("").text("").number(0);
    return message;
}

}  // namespace OCL::recording
