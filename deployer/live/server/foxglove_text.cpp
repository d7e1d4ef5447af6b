// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "foxglove_text.hpp"

#include "oro_messages.hpp"

#include <cstring>

namespace OCL::live {
namespace {

using nlohmann::json;

constexpr char kData = 1, kTime = 2, kResponse = 3, kCall = 2;
constexpr std::int64_t kSecond = 1000000000;

/** Numbers travel with the lowest byte first. */
template <class Number>
void add(std::string& to, Number number) {
    for (unsigned i = 0; i != sizeof number; ++i) to += static_cast<char>(number >> (8 * i));
}

std::uint32_t numberAt(std::string_view text, std::size_t at) {
    std::uint32_t number = 0;
    for (unsigned i = 0; i != sizeof number; ++i)
        number |= std::uint32_t(static_cast<unsigned char>(text[at + i])) << (8 * i);
    return number;
}

}  // namespace

std::string foxgloveStatus(int level, const std::string& text) {
    return textOf({{"op", "status"}, {"level", level}, {"message", text}});
}

std::string foxgloveServerInfo(const std::string& name, const std::string& session, bool callsServices) {
    json capabilities = {"time", "parameters", "parametersSubscribe", "connectionGraph"};
    if (callsServices) capabilities.push_back("services");
    return textOf({{"op", "serverInfo"},
                   {"name", name},
                   {"capabilities", capabilities},
                   {"supportedEncodings", {"json"}},
                   {"metadata", json::object()},
                   {"sessionId", session}});
}

json foxgloveLogChannel() {
    const json text = {{"type", "string"}}, number = {{"type", "integer"}};
    const json time = {{"type", "object"}, {"title", "time"}, {"properties", {{"sec", number}, {"nsec", number}}}};
    const json schema = {{"title", "foxglove.Log"},
                         {"type", "object"},
                         {"properties",
                          {{"timestamp", time},
                           {"level", number},
                           {"message", text},
                           {"name", text},
                           {"file", text},
                           {"line", number}}}};
    return {{"id", kLogChannel},        {"topic", "/rosout"},
            {"encoding", "json"},       {"schemaName", "foxglove.Log"},
            {"schema", textOf(schema)}, {"schemaEncoding", "jsonschema"}};
}

std::string foxgloveLogLine(const LogLine& line) {
    // Never, Fatal, Critical, Error, Warning, Info, Debug, RealTime
    constexpr int levels[] = {0, 5, 5, 4, 3, 2, 1, 1};
    return textOf({{"timestamp", {{"sec", line.time / kSecond}, {"nsec", line.time % kSecond}}},
                   {"level", levels[line.level]},
                   {"message", line.text},
                   {"name", line.origin},
                   {"file", ""},
                   {"line", 0}});
}

json foxgloveParameter(const std::string& name, const json& property) {
    json made = {{"name", name}, {"value", property.value("value", json())}};
    const std::string type = property.value("type", "");
    if ((type == "double" || type == "float") && made["value"].is_number()) made["type"] = "float64";
    return made;
}

std::string foxgloveData(std::uint32_t subscription, std::uint64_t time, std::string_view payload) {
    std::string message(1, kData);
    add(message, subscription);
    add(message, time);
    message.append(payload);
    return message;
}

std::string foxgloveTime(std::uint64_t time) {
    std::string message(1, kTime);
    add(message, time);
    return message;
}

std::string foxgloveResponse(std::uint32_t service, std::uint32_t call, std::string_view encoding,
                             std::string_view payload) {
    std::string message(1, kResponse);
    add(message, service);
    add(message, call);
    add(message, static_cast<std::uint32_t>(encoding.size()));
    message.append(encoding).append(payload);
    return message;
}

bool parseFoxgloveCall(std::string_view message, FoxgloveCall& call) {
    constexpr std::size_t head = 13;
    if (message.size() < head || message[0] != kCall) return false;
    const std::uint32_t length = numberAt(message, 9);
    if (length > message.size() - head) return false;
    call = {numberAt(message, 1), numberAt(message, 5), std::string(message.substr(head, length)),
            message.substr(head + length)};
    return true;
}

}  // namespace OCL::live
