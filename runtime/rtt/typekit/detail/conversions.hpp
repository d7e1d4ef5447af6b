// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_BUILTIN_CONVERSIONS_HPP
#define ORO_BUILTIN_CONVERSIONS_HPP

#include <rtt/types/TemplateConstructor.hpp>
#include <rtt/types/number_conversion.hpp>

namespace RTT {
namespace types {
namespace builtin {

struct Conversion {
    TypeRef to, from;
    bool automatic;
    ComputeFunction call;
};

template <class To, class From>
bool convertNumber(const void*, const void* const* arguments, void* result) {
    *static_cast<To*>(result) = types::detail::converted<To>(*static_cast<const From*>(arguments[0]));
    return true;
}

/** A conversion without a warning. */
template <class To, class From>
constexpr Conversion silent() {
    return {&typeRef<To>, &typeRef<From>, true, &convertNumber<To, From>};
}

/** A conversion that scripts may use, with a warning. */
template <class To, class From>
constexpr Conversion warned() {
    return {&typeRef<To>, &typeRef<From>, false, &convertNumber<To, From>};
}

/** Adds each to the type it converts to. */
void addConversions(const Conversion* rows, std::size_t count);

template <std::size_t N>
void addConversions(const Conversion (&rows)[N]) {
    addConversions(rows, N);
}

}  // namespace builtin
}  // namespace types
}  // namespace RTT

#endif
