// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "json.hpp"

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

std::string lineOf(const Json& value) { return value.dump(-1, ' ', false, Json::error_handler_t::replace); }

Json parsed(const std::string& text) {
    return isTooDeep(text) ? Json(Json::value_t::discarded) : Json::parse(text, nullptr, false);
}

}  // namespace oroforge::live_client
