// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "builtin_parts.hpp"
#include "operator_rows.hpp"

#include <type_traits>

namespace RTT::types::builtin {

namespace {

/** Unsigned arithmetic, so that overflow wraps instead of being undefined. */
template <class T, class F>
T wrapped(F f, T a, T b) {
    using U = std::make_unsigned_t<T>;
    return static_cast<T>(f(static_cast<U>(a), static_cast<U>(b)));
}

struct Plus {
    template <class T>
    T operator()(T a, T b) const {
        return wrapped<T>(std::plus<>(), a, b);
    }
};
struct Minus {
    template <class T>
    T operator()(T a, T b) const {
        return wrapped<T>(std::minus<>(), a, b);
    }
};
struct Times {
    template <class T>
    T operator()(T a, T b) const {
        return wrapped<T>(std::multiplies<>(), a, b);
    }
};
struct Negate {
    template <class T>
    T operator()(T a) const {
        return wrapped<T>(std::minus<>(), T(0), a);
    }
};
struct Same {
    template <class T>
    T operator()(T a) const {
        return a;
    }
};

/** Division or remainder by zero yields 0, and evaluation of the expression fails. */
template <class T, bool remainder>
bool divide(const void*, const void* const* arguments, void* result) {
    const T a = *static_cast<const T*>(arguments[0]);
    const T b = *static_cast<const T*>(arguments[1]);
    T& quotient = *static_cast<T*>(result);
    quotient = 0;
    if (b == 0) return false;
    // The one overflow of division: the most negative number by -1.
    if (std::is_signed_v<T> && b == static_cast<T>(-1))
        quotient = remainder ? 0 : Negate()(a);
    else
        quotient = remainder ? a % b : a / b;
    return true;
}

template <class T>
void addInteger() {
    static constexpr OperatorRow rows[] = {
        unary<Same, T>("+"),
        binary<Times, T>("*"),
        {"/", &typeRef<T>, &typeRef<T>, &typeRef<T>, &divide<T, false>},
        {"%", &typeRef<T>, &typeRef<T>, &typeRef<T>, &divide<T, true>},
        binary<Plus, T>("+"),
        binary<Minus, T>("-"),
    };
    static constexpr OperatorRow negation = unary<Negate, T>("-");
    operators()->add(rows, sizeof rows / sizeof rows[0]);
    if (std::is_signed_v<T>) operators()->add(&negation, 1);
    addComparisons<T>();
}

template <class T>
void addReal() {
    static constexpr OperatorRow rows[] = {
        unary<std::negate<>, T>("-"),   unary<Same, T>("+"),         binary<std::multiplies<>, T>("*"),
        binary<std::divides<>, T>("/"), binary<std::plus<>, T>("+"), binary<std::minus<>, T>("-"),
    };
    operators()->add(rows, sizeof rows / sizeof rows[0]);
    addComparisons<T>();
}

constexpr OperatorRow logic[] = {
    unary<std::logical_not<>, bool>("!"),    binary<std::logical_and<>, bool>("&&"),
    binary<std::logical_or<>, bool>("||"),   binary<std::equal_to<>, bool>("=="),
    binary<std::not_equal_to<>, bool>("!="),
};

}  // namespace

void addNumberOperators() {
    operators()->add(logic, sizeof logic / sizeof logic[0]);
    addInteger<int>();
    addInteger<unsigned int>();
    addInteger<long long>();
    addInteger<unsigned long long>();
    addReal<double>();
    addReal<float>();
}

}  // namespace RTT::types::builtin
