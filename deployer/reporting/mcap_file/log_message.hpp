// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_RECORDING_LOG_MESSAGE_HPP
#define OROFORGE_RECORDING_LOG_MESSAGE_HPP

#include "cdr_text.hpp"

#include <reporting/mcap/records.hpp>

#include <cstdint>
#include <string_view>

namespace OCL::recording {

/** The log in a file: the topic /rosout with messages that viewers show as a log, rcl_interfaces/msg/Log. */
oroforge::mcap::Schema logSchema(std::uint16_t id);
oroforge::mcap::Channel logChannel(std::uint16_t id, std::uint16_t schema);

/** How ROS 2 counts levels. */
enum class LogLevel : std::uint8_t { Debug = 10, Info = 20, Warning = 30, Error = 40, Fatal = 50 };

/** A line. @param time in ns. @param origin the module, component or thread. */
CdrText logMessage(std::uint64_t time, LogLevel level, std::string_view origin, std::string_view text);

}  // namespace OCL::recording

#endif
