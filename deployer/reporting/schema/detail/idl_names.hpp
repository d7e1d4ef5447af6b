// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_SCHEMA_IDL_NAMES_HPP
#define OROFORGE_SCHEMA_IDL_NAMES_HPP

#include "../message_schema.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace oroforge::schema {

/** A type where it is used: a basic one, or a name that is looked for once all of the text is read. */
struct IdlType {
    Basic basic = Basic::Struct;
    std::string name, scope;  // of what is not basic; "a::b::" is where the name is used
    std::vector<Many> lists;
    std::size_t line = 0;
};

/** What the name of a type means: a struct, or another type; an enum is an integer. */
struct IdlMeaning {
    bool isStruct = false;
    std::size_t structAt = 0;
    IdlType other;
};

/** What the names of a text mean. */
struct IdlNames {
    std::map<std::string, IdlMeaning> types;
    std::map<std::string, std::int64_t> constants;
};

/** Looks for a name in a scope and those around it. */
template <class Map>
typename Map::const_iterator findName(const Map& map, std::string scope, std::string_view name) {
    if (name.substr(0, 2) == "::") return map.find(std::string(name.substr(2)));
    for (;;) {
        const auto found = map.find(scope + std::string(name));
        if (found != map.end() || scope.empty()) return found;
        scope.resize(scope.size() - 2);
        const std::size_t last = scope.rfind("::");
        scope.resize(last == std::string::npos ? 0 : last + 2);
    }
}

}  // namespace oroforge::schema

#endif
