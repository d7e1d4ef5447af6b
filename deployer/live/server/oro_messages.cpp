// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "oro_messages.hpp"

namespace OCL::live {

using nlohmann::json;

std::string textOf(const json& message) { return message.dump(-1, ' ', false, json::error_handler_t::replace); }

std::string oroAnswer(const json& id, json result) {
    return textOf({{"op", "oro.answer"}, {"id", id}, {"result", std::move(result)}});
}

std::string oroError(const json& id, const char* code, const std::string& message) {
    return textOf({{"op", "oro.error"}, {"id", id}, {"code", code}, {"message", message}});
}

std::string oroSample(const json& id, std::int64_t time, const std::string& value, std::uint64_t dropped) {
    return R"({"op":"oro.sample","id":)" + textOf(id) + R"(,"time":)" + std::to_string(time) + R"(,"value":)" + value +
           R"(,"dropped":)" + std::to_string(dropped) + "}";
}

}  // namespace OCL::live
