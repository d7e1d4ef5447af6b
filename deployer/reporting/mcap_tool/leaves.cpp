// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "leaves.hpp"

#include <cstdio>
#include <iostream>
#include <utility>

namespace oroforge::mcap {
namespace {

constexpr const char* kUnreadable = "MCP012";

}  // namespace

const RosSchema* Decoders::of(const Channel& channel, const Schema* schema) {
    const auto [at, isNew] = known_.try_emplace(channel.id);
    auto& [good, parsed] = at->second;
    if (isNew) {
        std::string why;
        if (channel.encoding != "cdr")
            why = "its messages are encoded as '" + channel.encoding + "', and only cdr is read";
        else if (!schema)
            why = "the file has no schema for it";
        else if (schema->encoding != "ros2msg")
            why = "its type is described as '" + schema->encoding +
                  "', and only ros2msg is read (see the properties "
                  "Schema and RosNames of the recorder)";
        else
            good = parsed.parse(schema->data, why);
        if (!good) {
            failed_ = true;
            std::cerr << file_ << ": error: [" << kUnreadable << "] topic '" << channel.topic << "': " << why << "\n";
        }
    }
    return good ? &parsed : nullptr;
}

bool Decoders::walk(const Channel& channel, const Schema* schema, const Message& message, PartTaker& taker) {
    const RosSchema* const decoder = of(channel, schema);
    std::string why;
    if (!decoder) return false;
    if (decoder->walk(message.data, message.size, taker, why)) return true;
    failed_ = true;
    std::cerr << file_ << ": error: [" << kUnreadable << "] topic '" << channel.topic << "': the message at "
              << secondsOf(message.logTime) << " does not fit its schema: " << why << "\n";
    return false;
}

std::string secondsOf(std::uint64_t time) {
    char text[48];
    (void)std::snprintf(text, sizeof text, "%llu.%09llu", static_cast<unsigned long long>(time / 1000000000U),
                        static_cast<unsigned long long>(time % 1000000000U));
    return text;
}

}  // namespace oroforge::mcap
