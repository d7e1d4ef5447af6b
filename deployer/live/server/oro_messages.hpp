// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Text of the messages that this server writes itself.
#ifndef OROFORGE_LIVE_ORO_MESSAGES_HPP
#define OROFORGE_LIVE_ORO_MESSAGES_HPP

#include "../requests/failure.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>

namespace OCL::live {

// deployer/explain has a text for each. The others are those of ../requests/failure.hpp.
inline constexpr const char* kNotWatchable = "LIV020";
inline constexpr const char* kNoSuchStream = "LIV021";

/** As text; what is not UTF-8 becomes U+FFFD. */
std::string textOf(const nlohmann::json& message);
std::string oroAnswer(const nlohmann::json& id, nlohmann::json result);
std::string oroError(const nlohmann::json& id, const char* code, const std::string& message);
/** `value` is JSON text, `time` ns since 1970. */
std::string oroSample(const nlohmann::json& id, std::int64_t time, const std::string& value, std::uint64_t dropped);

}  // namespace OCL::live

#endif
