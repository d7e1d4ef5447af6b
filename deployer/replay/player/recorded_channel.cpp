// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "recorded_channel.hpp"

#include <rtt/types/TypeInfoRepository.hpp>

#include <string_view>
#include <utility>
#include <vector>

namespace OCL::replay {
namespace {

namespace mcap = oroforge::mcap;

/** What the messages of std_msgs are with which numbers and texts are recorded; some types have several names. */
const std::vector<std::pair<std::string_view, std::vector<const char*>>> kStandard = {
    {"Bool", {"bool"}},
    {"Byte", {"uint8", "uchar"}},
    {"Char", {"char"}},
    {"Int8", {"int8"}},
    {"UInt8", {"uint8", "uchar"}},
    {"Int16", {"int16", "short"}},
    {"UInt16", {"uint16", "ushort"}},
    {"Int32", {"int", "int32"}},
    {"UInt32", {"uint", "uint32"}},
    {"Int64", {"int64", "llong", "long"}},
    {"UInt64", {"uint64", "ullong", "ulong"}},
    {"Float32", {"float", "float32"}},
    {"Float64", {"double", "float64"}},
    {"String", {"string"}}};

std::string textOf(const mcap::Channel& channel, const char* name) {
    const auto found = channel.metadata.find(name);
    return found == channel.metadata.end() ? "" : found->second;
}

/** "tank/msg/Level" and "tank::Level" have two parts. */
std::vector<std::string> partsOf(const std::string& name) {
    std::vector<std::string> parts(1);
    for (const char c : name) {
        if (c != '/' && c != ':')
            parts.back() += c;
        else if (!parts.back().empty())
            parts.emplace_back();
    }
    if (parts.back().empty()) parts.pop_back();
    if (parts.size() > 2 && parts[parts.size() - 2] == "msg") parts.erase(parts.end() - 2);
    return parts;
}

std::string joined(const std::vector<std::string>& parts, const char* between) {
    std::string all;
    for (const std::string& part : parts) all += (all.empty() ? "" : between) + part;
    return all;
}

/** What a type of that schema may be called here. */
std::vector<std::string> namesFor(const std::string& schema) {
    const std::vector<std::string> parts = partsOf(schema);
    std::vector<std::string> names;
    if (parts.size() == 2 && parts[0] == "std_msgs")
        for (const auto& [standard, types] : kStandard)
            if (standard == parts[1]) names.insert(names.end(), types.begin(), types.end());
    names.push_back("/" + joined(parts, "/"));
    names.push_back(joined(parts, "::"));
    if (parts.size() == 2 && parts[0] == "oroforge") names.push_back(parts[1]);
    names.push_back(schema);
    return names;
}

}  // namespace

bool isPort(const mcap::Channel& channel) {
    const std::string kind = textOf(channel, "oroforge.kind");
    if (!kind.empty()) return kind == "port";
    return channel.topic != "/oroforge/states" && channel.topic != "/rosout";
}

Topic topicOf(const mcap::Channel& channel, const mcap::Schema* schema) {
    Topic result;
    result.topic = channel.topic;
    result.type = textOf(channel, "oroforge.type");
    if (result.type.empty() && schema) result.type = schema->name;
    const std::string source = textOf(channel, "oroforge.source");
    if (const std::size_t dot = source.find('.'); dot != std::string::npos && dot != 0 && dot + 1 != source.size()) {
        result.component = source.substr(0, dot);
        result.port = source.substr(dot + 1);
        return result;
    }
    std::vector<std::string> parts = partsOf(channel.topic);
    if (parts.size() > 1) {
        result.component = parts.front();
        parts.erase(parts.begin());
    }
    result.port = joined(parts, ".");
    return result;
}

const RTT::types::TypeInfo* typeOf(const mcap::Channel& channel, const mcap::Schema* schema, std::string& why) {
    const auto types = RTT::types::Types();
    const std::string own = textOf(channel, "oroforge.type");
    if (!own.empty()) {
        if (const RTT::types::TypeInfo* const type = types->type(own)) return type;
    } else if (schema) {
        for (const std::string& name : namesFor(schema->name))
            if (const RTT::types::TypeInfo* const type = types->type(name)) return type;
    }
    if (own.empty() && !schema)
        why = "the file does not say what type its messages have";
    else
        why = "its type '" + (own.empty() ? schema->name : own) +
              "' is not loaded; import the typekit with it, or leave the topic out";
    return nullptr;
}

}  // namespace OCL::replay
