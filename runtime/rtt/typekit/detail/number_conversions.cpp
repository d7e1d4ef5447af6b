// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "builtin_parts.hpp"
#include "conversions.hpp"

#include <type_traits>

namespace RTT::types::builtin {

void addConversions(const Conversion* rows, std::size_t count) {
    for (std::size_t i = 0; i != count; ++i) {
        ErasedFunction function;
        function.call = rows[i].call;
        function.result = rows[i].to;
        function.arity = 1;
        function.arguments = {rows[i].from};
        Types()
            ->getTypeById(rows[i].to())
            ->addConstructor(types::detail::newErasedConstructor(function, rows[i].automatic));
    }
}

namespace {

using llong = long long;
using ullong = unsigned long long;

constexpr Conversion conversions[] = {
    silent<double, float>(),
    silent<double, int>(),
    silent<double, llong>(),
    silent<double, ullong>(),
    silent<float, int>(),
    silent<float, double>(),
    silent<float, llong>(),
    silent<float, ullong>(),
    silent<int, unsigned>(),
    silent<int, bool>(),
    silent<int, llong>(),
    silent<int, ullong>(),
    warned<int, float>(),
    warned<int, double>(),
    silent<unsigned, int>(),
    silent<unsigned, llong>(),
    silent<unsigned, ullong>(),
    silent<llong, float>(),
    silent<llong, double>(),
    silent<llong, int>(),
    silent<llong, unsigned>(),
    silent<llong, ullong>(),
    silent<ullong, float>(),
    silent<ullong, double>(),
    silent<ullong, int>(),
    silent<ullong, unsigned>(),
    silent<ullong, llong>(),
    // From a small integer to each type that has all its values.
    silent<int, signed char>(),
    silent<int, unsigned char>(),
    silent<int, short>(),
    silent<int, unsigned short>(),
    silent<unsigned, unsigned char>(),
    silent<unsigned, unsigned short>(),
    silent<llong, long>(),
    silent<ullong, unsigned long>(),
    silent<double, long>(),
    silent<double, unsigned long>(),
};

/** To a small integer: evaluation fails if the number does not fit. */
template <class To, class From>
bool narrow(const void*, const void* const* arguments, void* result) {
    const From from = *static_cast<const From*>(arguments[0]);
    const To to = static_cast<To>(from);
    if (static_cast<From>(to) != from || (to < 0) != (from < 0)) return false;
    *static_cast<To*>(result) = to;
    return true;
}

template <class To, class From>
constexpr Conversion narrowed() {
    return {&typeRef<To>, &typeRef<From>, true, &narrow<To, From>};
}

constexpr Conversion narrowings[] = {
    narrowed<signed char, int>(),
    narrowed<unsigned char, int>(),
    narrowed<unsigned char, unsigned>(),
    narrowed<short, int>(),
    narrowed<unsigned short, int>(),
    narrowed<unsigned short, unsigned>(),
    narrowed<long, int>(),
    narrowed<long, llong>(),
    narrowed<unsigned long, int>(),
    narrowed<unsigned long, unsigned>(),
    narrowed<unsigned long, ullong>(),
    narrowed<long, unsigned>(),
};

}  // namespace

void addNumberConversions() {
    addConversions(conversions);
    addConversions(narrowings);
}

}  // namespace RTT::types::builtin
