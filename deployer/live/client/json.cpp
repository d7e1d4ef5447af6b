// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "json.hpp"

#include <cstdio>

namespace oroforge::live_client {
namespace {

constexpr int kDeepest = 100;  // what reads and writes JSON calls itself for each level

bool isTooDeep(const std::string& text) {
    int depth = 0;
    bool quoted = false;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char c = text[at];
        if (quoted && c == '\\')
            ++at;
        else if (c == '"')
            quoted = !quoted;
        else if (!quoted && (c == '[' || c == '{') && ++depth > kDeepest)
            return true;
        else if (!quoted && (c == ']' || c == '}'))
            --depth;
    }
    return false;
}

}  // namespace

const Json& memberOf(const Json& object, const std::string& name) {
    static const Json kNone;
    if (!object.is_object()) return kNone;
    const auto found = object.find(name);
    return found == object.end() ? kNone : *found;
}

std::string textOf(const Json& object, const std::string& name) {
    const Json& found = memberOf(object, name);
    if (found.is_null()) return {};
    return found.is_string() ? found.get_ref<const std::string&>() : lineOf(found);
}

double numberOf(const Json& object, const std::string& name, double otherwise) {
    const Json& found = memberOf(object, name);
    return found.is_number() ? found.get<double>() : otherwise;
}

long long wholeOf(const Json& object, const std::string& name, long long otherwise) {
    const Json& found = memberOf(object, name);
    return found.is_number_integer() ? found.get<long long>() : otherwise;
}

bool truthOf(const Json& object, const std::string& name) {
    const Json& found = memberOf(object, name);
    return found.is_boolean() && found.get<bool>();
}

// A terminal obeys some characters that JSON leaves as they are, U+007F to U+009F.
std::string lineOf(const Json& value) {
    const std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (text.find_first_of("\x7F\xC2") == std::string::npos) return text;
    std::string line;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const auto code =
            static_cast<unsigned char>(text[at] == '\xC2' && at + 1 < text.size() ? text[++at] : text[at]);
        const bool wide = at > 0 && text[at - 1] == '\xC2';
        char escaped[8];
        std::snprintf(escaped, sizeof escaped, "\\u%04x", static_cast<unsigned>(code));
        if (code == 0x7F || (wide && code < 0xA0))
            line += escaped;
        else if (wide)
            line += text.substr(at - 1, 2);
        else
            line += text[at];
    }
    return line;
}

Json parsed(const std::string& text) {
    return isTooDeep(text) ? Json(Json::value_t::discarded) : Json::parse(text, nullptr, false);
}

}  // namespace oroforge::live_client
