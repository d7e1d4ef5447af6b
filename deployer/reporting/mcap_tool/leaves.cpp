// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "leaves.hpp"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <utility>

namespace oroforge::mcap {
namespace {

constexpr const char* kUnreadable = "MCP012";

}  // namespace

const schema::MessageSchema* Decoders::of(const Channel& channel, const Schema* described) {
    const auto [at, isNew] = known_.try_emplace(channel.id);
    auto& [good, parsed] = at->second;
    if (isNew) {
        std::string why;
        if (channel.encoding != "cdr")
            why = "its messages are encoded as '" + channel.encoding + "', and only cdr is read";
        else if (!described)
            why = "the file has no schema for it";
        else
            good = parsed.read(described->encoding, described->name, described->data, why);
        if (!good) {
            failed_ = true;
            std::cerr << file_ << ": error: [" << kUnreadable << "] topic '" << channel.topic << "': " << why << "\n";
        }
    }
    return good ? &parsed : nullptr;
}

bool Decoders::walk(const Channel& channel, const Schema* described, const Message& message, schema::PartTaker& taker) {
    const schema::MessageSchema* const decoder = of(channel, described);
    std::string why;
    if (!decoder) return false;
    if (decoder->walk(message.data, message.size, taker, why)) return true;
    failed_ = true;
    // Some commands walk through the messages twice.
    const auto [until, isFirst] = reportedUntil_.try_emplace(channel.id, message.logTime);
    if (!isFirst && message.logTime <= until->second) return false;
    until->second = message.logTime;
    std::cerr << file_ << ": error: [" << kUnreadable << "] topic '" << channel.topic << "': the message at "
              << secondsOf(message.logTime) << " does not fit its schema: " << why << "\n";
    return false;
}

std::string sourceOf(const Channel& channel) {
    const auto found = channel.metadata.find("oroforge.source");
    std::string name = found == channel.metadata.end() ? channel.topic : found->second;
    if (name.size() > 1 && name[0] == '/') name.erase(0, 1);
    std::replace(name.begin(), name.end(), '/', '.');
    return name;
}

std::string nameOf(const std::string& source, const std::string& path) {
    constexpr std::string_view kOnly = "data";
    if (path.compare(0, kOnly.size(), kOnly) != 0) return source + "." + path;
    const std::string rest = path.substr(kOnly.size());
    return rest.empty() || rest[0] == '[' ? source + rest : source + "." + path;
}

std::string secondsOf(std::uint64_t time) {
    char text[48];
    (void)std::snprintf(text, sizeof text, "%llu.%09llu", static_cast<unsigned long long>(time / 1000000000U),
                        static_cast<unsigned long long>(time % 1000000000U));
    return text;
}

}  // namespace oroforge::mcap
