// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The types with which instructions compute directly; values of other types stay in their data sources.
#ifndef ORO_SCRIPTING_DETAIL_KINDS_HPP
#define ORO_SCRIPTING_DETAIL_KINDS_HPP

#include <rtt/base/DataSourceBase.hpp>

#include <cstdint>
#include <typeinfo>

namespace RTT::scripting::detail {

enum class Kind : std::uint8_t { Bool, Char, Int, UInt, LLong, ULLong, Float, Double, Other, None };

constexpr int kDirectKinds = static_cast<int>(Kind::Other);

inline bool isDirect(Kind kind) { return kind < Kind::Other; }

/** The kind of a source: None for void, Other for a type without a kind. */
Kind kindOf(const base::DataSourceBase& source);
/** The kind of a type; Other for null. */
Kind kindOf(const std::type_info* id);
/** The kind that holds all values of the small number types, such as int8 and int64, which have none; Other for all
    others. */
Kind widened(const std::type_info* id);

template <class T>
struct Type {
    typedef T type;
};

/** Calls `f` with the Type of a direct kind. */
template <class F>
auto withType(Kind kind, F f) {
    switch (kind) {
        case Kind::Bool: return f(Type<bool>());
        case Kind::Char: return f(Type<char>());
        case Kind::Int: return f(Type<int>());
        case Kind::UInt: return f(Type<unsigned int>());
        case Kind::LLong: return f(Type<long long>());
        case Kind::ULLong: return f(Type<unsigned long long>());
        case Kind::Float: return f(Type<float>());
        default: return f(Type<double>());
    }
}

}  // namespace RTT::scripting::detail

#endif
