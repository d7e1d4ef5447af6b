// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "value_text.hpp"

#include "output.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace oroforge::live_client {
namespace {

constexpr std::size_t kMostElements = 10;  // as many as the console shows
constexpr std::size_t kMostLeaves = 10000;

std::string numberText(const Json& number) {
    if (!number.is_number_float()) return lineOf(number);
    // The shortest text that reads back as the same number.
    char text[40];
    for (const int digits : {6, 15, 16, 17}) {
        std::snprintf(text, sizeof text, "%.*g", digits, number.get<double>());
        if (std::strtod(text, nullptr) == number.get<double>()) break;
    }
    return text;
}

std::string sequenceText(const Json& value) {
    std::string text = "[";
    for (std::size_t i = 0; i != value.size(); ++i) {
        if (i == kMostElements && value.size() > kMostElements + 1)
            return text + ", … " + std::to_string(value.size() - kMostElements) + " more]";
        text += (i ? ", " : "") + valueText(value[i]);
    }
    return text + "]";
}

void collect(const Json& value, const std::string& path, std::vector<std::pair<std::string, Json>>& leaves) {
    if (leaves.size() >= kMostLeaves) return;
    if (value.is_object()) {
        for (const auto& member : value.items())
            collect(member.value(), path + (path.empty() ? "" : ".") + member.key(), leaves);
    } else if (value.is_array()) {
        for (std::size_t i = 0; i != value.size(); ++i) collect(value[i], path + "[" + std::to_string(i) + "]", leaves);
    } else {
        leaves.emplace_back(path, value);
    }
}

}  // namespace

std::string valueText(const Json& value) {
    if (value.is_object()) {
        std::string text;
        for (const auto& member : value.items())
            text += (text.empty() ? "" : ", ") + printable(member.key()) + " = " + valueText(member.value());
        return "{" + text + "}";
    }
    if (value.is_array()) return sequenceText(value);
    if (value.is_string()) return printable(lineOf(value));
    return value.is_number() ? numberText(value) : lineOf(value);
}

std::string shownText(const Json& object) {
    const std::string text = textOf(object, "text");
    if (!text.empty()) return OCL::console::valueOnOneLine(printable(text));
    const Json& value = memberOf(object, "value");
    return value.is_null() ? "" : valueText(value);
}

std::string plainText(const Json& value) {
    if (value.is_string()) return value.get<std::string>();
    return value.is_number() ? numberText(value) : lineOf(value);
}

std::vector<std::pair<std::string, Json>> leavesOf(const Json& value) {
    std::vector<std::pair<std::string, Json>> leaves;
    collect(value, "", leaves);
    return leaves;
}

const Json* memberAt(const Json& value, const std::string& path) {
    const Json* now = &value;
    for (std::size_t at = 0; at < path.size() && now;) {
        if (path[at] == '.') {
            ++at;
        } else if (path[at] == '[') {
            char* end = nullptr;
            const unsigned long index = std::strtoul(path.c_str() + at + 1, &end, 10);
            if (!now->is_array() || *end != ']' || index >= now->size()) return nullptr;
            now = &(*now)[index];
            at = static_cast<std::size_t>(end - path.c_str()) + 1;
        } else {
            const std::size_t end = std::min(path.find_first_of(".[", at), path.size());
            const std::string name = path.substr(at, end - at);
            if (now->is_array()) {  // `joints.2`, as some write it
                char* rest = nullptr;
                const unsigned long index = std::strtoul(name.c_str(), &rest, 10);
                now = *rest || index >= now->size() ? nullptr : &(*now)[index];
            } else {
                const Json& member = memberOf(*now, name);
                now = member.is_null() && !(now->is_object() && now->contains(name)) ? nullptr : &member;
            }
            at = end;
        }
    }
    return now;
}

bool lacksElement(const Json& value, const std::string& path) {
    for (std::size_t end = 0; end < path.size();) {
        const Json* const sequence = memberAt(value, path.substr(0, end));
        if (!sequence) return false;
        const std::size_t begin = end;
        end = std::min(path.find_first_of(".[", begin + 1), path.size());
        const bool isIndex = path[begin] == '[' || std::isdigit(static_cast<unsigned char>(path[begin + 1]));
        if (sequence->is_array() && isIndex && !memberAt(value, path.substr(0, end))) return true;
    }
    return false;
}

std::optional<double> asNumber(const Json& value) {
    if (value.is_number()) return value.get<double>();
    if (value.is_boolean()) return value.get<bool>() ? 1 : 0;
    if (value == "NaN") return std::numeric_limits<double>::quiet_NaN();
    if (value == "Infinity") return std::numeric_limits<double>::infinity();
    if (value == "-Infinity") return -std::numeric_limits<double>::infinity();
    return std::nullopt;
}

}  // namespace oroforge::live_client
