// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "sample_batch.hpp"

#include "oro_messages.hpp"

#include <rtt/encoding/SchemaText.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

namespace OCL::live {
namespace {

constexpr char kSamples = '\x80';
/** If the queue must drop some, it drops whole messages. */
constexpr std::size_t kFullMessage = 32 * 1024;

template <class Number>
void add(std::string& to, Number number) {
    for (std::size_t i = 0; i != sizeof number; ++i) to.push_back(static_cast<char>(number >> (8 * i)));
}

}  // namespace

void SampleBatches::readAll(PortWatch& port, MessageQueue& queue, unsigned most) {
    std::string message, value;
    const auto send = [&] {
        if (!message.empty()) queue.addSample(channel_, {std::move(message), true});
        message.clear();
    };
    for (unsigned i = 0; i != most && port.read(value); ++i) {
        // What was dropped is older than what is read first.
        if (i == 0) dropped_ = std::max(dropped_, port.dropped());
        const std::uint64_t number = next();
        ++taken_;
        if (value.empty()) continue;  // it cannot be encoded
        if (message.empty()) {
            message.push_back(kSamples);
            add(message, stream());
        }
        add(message, static_cast<std::uint32_t>(value.size()));
        add(message, static_cast<std::uint64_t>(port.time()));
        add(message, number);
        message += value;
        if (message.size() > kFullMessage) send();
    }
    send();
}

nlohmann::json schemaOf(const PortWatch& port) {
    RTT::encoding::SchemaText schema;
    std::string why;
    const RTT::types::TypeInfo& type = *port.value().getTypeInfo();
    if (!RTT::encoding::describeType(type, RTT::encoding::SchemaLanguage::Auto, false, schema, why))
        throw Failure(kNotWatchable, "samples of type '" + type.getTypeName() + "' cannot be described: " + why);
    nlohmann::json units = nlohmann::json::object();
    for (const auto& [field, unit] : schema.units) units[field] = unit;
    char fingerprint[17];
    (void)std::snprintf(fingerprint, sizeof fingerprint, "%016llx",
                        static_cast<unsigned long long>(port.fingerprint()));
    return {{"schema", {{"name", schema.name}, {"encoding", schema.encoding}, {"text", schema.text}}},
            {"units", std::move(units)},
            {"fingerprint", fingerprint}};
}

}  // namespace OCL::live
