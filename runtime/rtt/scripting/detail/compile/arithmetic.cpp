// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/compile/arithmetic.hpp>

#include <rtt/scripting/detail/execute/process.hpp>
#include <rtt/types/number_conversion.hpp>

#include <functional>
#include <type_traits>

namespace RTT::scripting::detail {

namespace {

template <class T>
T& at(void* place) {
    return *static_cast<T*>(place);
}
template <class T>
const T& at(const void* place) {
    return *static_cast<const T*>(place);
}

/** Integers wrap around. */
template <class T, class F>
T computed(F f, T a, T b) {
    if constexpr (std::is_integral_v<T>) {
        using U = std::make_unsigned_t<T>;
        return static_cast<T>(f(static_cast<U>(a), static_cast<U>(b)));
    } else {
        return f(a, b);
    }
}

template <class T, class F>
const Instruction* compute(const Instruction& self, Process&) {
    at<T>(self.to) = computed<T>(F(), at<T>(self.a), at<T>(self.b));
    return &self + 1;
}

template <class T, class F>
const Instruction* compare(const Instruction& self, Process&) {
    at<bool>(self.to) = F()(at<T>(self.a), at<T>(self.b));
    return &self + 1;
}

template <class T, bool remainder>
const Instruction* divide(const Instruction& self, Process& process) {
    const T a = at<T>(self.a), b = at<T>(self.b);
    if constexpr (std::is_integral_v<T>) {
        if (b == 0) return process.fail(remainder ? "remainder of a division by zero" : "division by zero");
        // The one overflow of division: the most negative number by -1.
        if (std::is_signed_v<T> && b == static_cast<T>(-1))
            at<T>(self.to) = remainder ? T(0) : computed<T>(std::minus<>(), T(0), a);
        else
            at<T>(self.to) = remainder ? a % b : a / b;
    } else {
        at<T>(self.to) = a / b;
    }
    return &self + 1;
}

template <class T>
const Instruction* negate(const Instruction& self, Process&) {
    at<T>(self.to) = std::is_integral_v<T> ? computed<T>(std::minus<>(), T(0), at<T>(self.a)) : -at<T>(self.a);
    return &self + 1;
}

template <class T>
const Instruction* copy(const Instruction& self, Process&) {
    at<T>(self.to) = at<T>(self.a);
    return &self + 1;
}

const Instruction* invert(const Instruction& self, Process&) {
    at<bool>(self.to) = !at<bool>(self.a);
    return &self + 1;
}

template <class From, class To>
const Instruction* convert(const Instruction& self, Process&) {
    at<To>(self.to) = types::detail::converted<To>(at<From>(self.a));
    return &self + 1;
}

template <class T>
Operation comparison(const std::string& op) {
    if (op == "==") return {&compare<T, std::equal_to<>>, Kind::Bool};
    if (op == "!=") return {&compare<T, std::not_equal_to<>>, Kind::Bool};
    if (op == "<") return {&compare<T, std::less<>>, Kind::Bool};
    if (op == ">") return {&compare<T, std::greater<>>, Kind::Bool};
    if (op == "<=") return {&compare<T, std::less_equal<>>, Kind::Bool};
    if (op == ">=") return {&compare<T, std::greater_equal<>>, Kind::Bool};
    return {};
}

Operation logic(const std::string& op) {
    if (op == "&&") return {&compare<bool, std::logical_and<>>, Kind::Bool};
    if (op == "||") return {&compare<bool, std::logical_or<>>, Kind::Bool};
    if (op == "==" || op == "!=") return comparison<bool>(op);
    return {};
}

template <class T>
Operation arithmetic(const std::string& op, Kind kind) {
    if (op == "+") return {&compute<T, std::plus<>>, kind};
    if (op == "-") return {&compute<T, std::minus<>>, kind};
    if (op == "*") return {&compute<T, std::multiplies<>>, kind};
    if (op == "/") return {&divide<T, false>, kind};
    if constexpr (std::is_integral_v<T>) {
        if (op == "%") return {&divide<T, true>, kind};
    }
    return comparison<T>(op);
}

bool isNumber(Kind kind) { return kind >= Kind::Int && kind <= Kind::Double; }

}  // namespace

Operation binaryOperation(const std::string& op, Kind kind) {
    if (kind == Kind::Bool) return logic(op);
    if (kind == Kind::Char) return comparison<char>(op);
    if (!isNumber(kind)) return {};
    return withType(kind, [&](auto type) -> Operation {
        using T = typename decltype(type)::type;
        if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, char>)
            return {};
        else
            return arithmetic<T>(op, kind);
    });
}

Operation unaryOperation(char op, Kind kind) {
    if (op == '!') return kind == Kind::Bool ? Operation{&invert, kind} : Operation{};
    const bool negates = isReal(kind) || kind == Kind::Int || kind == Kind::LLong;
    if (!isNumber(kind) || (op == '-' && !negates)) return {};
    return withType(kind, [&](auto type) -> Operation {
        using T = typename decltype(type)::type;
        if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, char>)
            return {};
        else
            return {op == '-' ? &negate<T> : &copy<T>, kind};
    });
}

Conversion conversion(Kind from, Kind to) {
    if (from == to) return Conversion::Silent;
    if (!isDirect(from) || !isDirect(to) || from == Kind::Char || to == Kind::Char) return Conversion::None;
    if (to == Kind::Bool) return from == Kind::Int || from == Kind::LLong ? Conversion::Silent : Conversion::None;
    if (from == Kind::Bool) return to == Kind::Int ? Conversion::Silent : Conversion::None;
    if (from == Kind::UInt && isReal(to)) return Conversion::None;
    if (isReal(from) && to == Kind::UInt) return Conversion::None;
    if (isReal(from) && to == Kind::Int) return Conversion::Warned;
    if (isReal(from) && !isReal(to)) return Conversion::Silent;
    return Conversion::Silent;
}

Action conversionAction(Kind from, Kind to) {
    if (conversion(from, to) == Conversion::None) return nullptr;
    return withType(from, [&](auto source) {
        return withType(to, [](auto target) -> Action {
            return &convert<typename decltype(source)::type, typename decltype(target)::type>;
        });
    });
}

void convertValue(Kind from, const void* a, Kind to, void* b) {
    withType(from, [&](auto source) {
        withType(to, [&](auto target) {
            typedef typename decltype(target)::type To;
            at<To>(b) = types::detail::converted<To>(at<typename decltype(source)::type>(a));
        });
    });
}

}  // namespace RTT::scripting::detail
