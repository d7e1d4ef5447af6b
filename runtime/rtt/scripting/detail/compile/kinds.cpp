// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/compile/kinds.hpp>

namespace RTT::scripting::detail {

Kind kindOf(const base::DataSourceBase& source) { return kindOf(source.getTypeId()); }

Kind kindOf(const std::type_info* id) {
    if (!id) return Kind::Other;
    if (*id == typeid(void)) return Kind::None;
    for (int i = 0; i != kDirectKinds; ++i) {
        const Kind kind = static_cast<Kind>(i);
        if (withType(kind, [&](auto type) { return *id == typeid(typename decltype(type)::type); })) return kind;
    }
    return Kind::Other;
}

Kind widened(const std::type_info* id) {
    if (!id) return Kind::Other;
    if (*id == typeid(signed char) || *id == typeid(unsigned char) || *id == typeid(short) ||
        *id == typeid(unsigned short))
        return Kind::Int;
    if (*id == typeid(long)) return Kind::LLong;
    return *id == typeid(unsigned long) ? Kind::ULLong : Kind::Other;
}

}  // namespace RTT::scripting::detail
