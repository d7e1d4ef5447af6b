// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "ros_text.hpp"

#include "limits.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string_view>
#include <utility>

namespace oroforge::schema {
namespace {

constexpr std::pair<std::string_view, Basic> kBasics[] = {
    {"bool", Basic::Bool},       {"byte", Basic::UInt8},  {"char", Basic::UInt8},      {"int8", Basic::Int8},
    {"uint8", Basic::UInt8},     {"int16", Basic::Int16}, {"uint16", Basic::UInt16},   {"int32", Basic::Int32},
    {"uint32", Basic::UInt32},   {"int64", Basic::Int64}, {"uint64", Basic::UInt64},   {"float32", Basic::Float32},
    {"float64", Basic::Float64}, {"string", Basic::Text}, {"wstring", Basic::WideText}};

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
    return text;
}

std::string_view takeWord(std::string_view& line) {
    std::size_t end = 0;
    while (end != line.size() && !isBlank(line[end])) ++end;
    const std::string_view word = line.substr(0, end);
    line = trimmed(line.substr(end));
    return word;
}

/** "[3]", "[]", "[<=3]" behind a type. */
bool takeBrackets(std::string_view& type, Field& field) {
    if (type.empty() || type.back() != ']') return true;
    const std::size_t open = type.rfind('[');
    if (open == std::string_view::npos) return false;
    const std::string size(type.substr(open + 1, type.size() - open - 2));
    type = type.substr(0, open);
    if (size.empty() || size[0] == '<') {
        field.lists.push_back({true, 0});
        return true;
    }
    char* end = nullptr;
    const std::size_t count = std::strtoull(size.c_str(), &end, 10);
    field.lists.push_back({false, count});
    return *end == '\0' && count != 0 && count <= kLongest;
}

/** "package/msg/Name" is "package/Name". */
std::string shortName(std::string_view name) {
    const std::size_t first = name.find('/'), last = name.rfind('/');
    if (first == last) return std::string(name);
    return std::string(name.substr(0, first)) + std::string(name.substr(last));
}

class RosText {
public:
    explicit RosText(std::vector<Struct>& structs) : structs_(structs) {}

    bool read(const std::string& text, std::string& why) {
        structs_.assign(1, {});
        std::size_t number = 0;
        for (std::size_t at = 0; at < text.size();) {
            const std::size_t end = std::min(text.find('\n', at), text.size());
            const std::string_view line = std::string_view(text).substr(at, end - at);
            at = end + 1;
            ++number;
            const std::string_view bare = trimmed(line.substr(0, line.find('#')));
            if (bare.empty() || addLine(bare, number, why)) continue;
            why = "line " + std::to_string(number) + ": " + why;
            return false;
        }
        return resolve(why);
    }

private:
    bool addLine(std::string_view line, std::size_t number, std::string& why) {
        if (line.substr(0, 3) == "===") return true;
        if (line.substr(0, 4) == "MSG:") {
            structs_.emplace_back();
            structs_.back().name = shortName(trimmed(line.substr(4)));
            return true;
        }
        Field field;
        field.line = number;
        const std::string_view word = takeWord(line);
        std::string_view type = word;
        if (!takeBrackets(type, field)) {
            why = "the brackets of '" + std::string(word) + "' have no valid number";
            return false;
        }
        if (const std::size_t limit = type.find("<="); limit != std::string_view::npos) type = type.substr(0, limit);
        field.name = takeWord(line);
        // "int8 LEFT=1" is a constant, "int8 side 1" has a default value.
        if (field.name.find('=') != std::string::npos || (!line.empty() && line.front() == '=')) return true;
        if (type.empty() || field.name.empty()) {
            why = "found '" + std::string(type) + "', expected a type and a name";
            return false;
        }
        field.type = shortName(type);
        for (const auto& [name, basic] : kBasics)
            if (name == type) field.basic = basic;
        structs_.back().fields.push_back(std::move(field));
        return true;
    }

    bool resolve(std::string& why) {
        std::map<std::string, std::size_t> byName, byLastName;
        for (std::size_t i = structs_.size(); i-- > 1;) {
            const std::string& name = structs_[i].name;
            byName[name] = i;
            byLastName[name.substr(name.find('/') + 1)] = i;
        }
        for (Struct& one : structs_) {
            one.hasByte = one.fields.empty();
            const std::string package = one.name.substr(0, one.name.find('/') + 1);
            for (Field& field : one.fields) {
                if (field.basic != Basic::Struct) continue;
                auto found = byName.find(field.type);
                auto end = byName.end();
                // Without a package it is that of the struct, or, in the message itself, any.
                if (found == end) found = byName.find(package + field.type);
                if (found == end && package.empty()) {
                    found = byLastName.find(field.type);
                    end = byLastName.end();
                }
                if (found == end) {
                    why = "line " + std::to_string(field.line) + ": the type '" + field.type + "' of the field '" +
                          field.name + "' is not described";
                    return false;
                }
                field.structAt = found->second;
            }
        }
        return true;
    }

    std::vector<Struct>& structs_;
};

}  // namespace

bool readRos(const std::string& text, std::vector<Struct>& structs, std::string& why) {
    return RosText(structs).read(text, why);
}

}  // namespace oroforge::schema
