// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Messages of Foxglove's WebSocket protocol.
#ifndef OROFORGE_LIVE_FOXGLOVE_TEXT_HPP
#define OROFORGE_LIVE_FOXGLOVE_TEXT_HPP

#include "../samples/log_lines.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <string_view>

namespace OCL::live {

constexpr std::uint32_t kLogChannel = 1;

/** Level 0: information, 1: warning, 2: error. */
std::string foxgloveStatus(int level, const std::string& text);
std::string foxgloveServerInfo(const std::string& name, const std::string& session, bool callsServices);
/** The channel of the log, /rosout. */
nlohmann::json foxgloveLogChannel();
std::string foxgloveLogLine(const LogLine& line);
/** `property` as in the answer to oro.show. */
nlohmann::json foxgloveParameter(const std::string& name, const nlohmann::json& property);

// Binary messages.
std::string foxgloveData(std::uint32_t subscription, std::uint64_t time, std::string_view payload);
std::string foxgloveTime(std::uint64_t time);
std::string foxgloveResponse(std::uint32_t service, std::uint32_t call, std::string_view encoding,
                             std::string_view payload);

/** A service that a client calls. */
struct FoxgloveCall {
    std::uint32_t service = 0, call = 0;
    std::string encoding;
    std::string_view payload;
};
/** False if the message is something else. */
bool parseFoxgloveCall(std::string_view message, FoxgloveCall& call);

}  // namespace OCL::live

#endif
