// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "builtin_parts.hpp"
#include "operator_rows.hpp"

#include <rtt/FlowStatus.hpp>
#include <rtt/SendStatus.hpp>
#include <rtt/rt_string.hpp>
#include <cstdio>
#include <new>
#include <sstream>
#include <string>

namespace RTT::types::builtin {

namespace {

/** Appends the text of a value to a text. Allocates. */
struct Append {
    template <class T>
    std::string operator()(const std::string& text, const T& value) const {
        std::ostringstream result;
        result << std::boolalpha << text << value;
        return result.str();
    }
};

template <class T>
constexpr OperatorRow append() {
    return binary<Append, std::string, std::string, T>("+");
}

constexpr OperatorRow appends[] = {
    append<std::string>(), append<int>(),  append<unsigned int>(), append<double>(),
    append<float>(),       append<bool>(), append<char>(),
};

/** The same for real-time strings: the text of a number is made on the stack, not the heap. */
struct Print {
    static void append(rt_string& to, const rt_string& text) { to += text; }
    static void append(rt_string& to, const std::string& text) { to.append(text.data(), text.size()); }
    static void append(rt_string& to, bool value) { to += value ? "true" : "false"; }
    static void append(rt_string& to, char value) { to += value; }
    static void append(rt_string& to, int value) { print(to, "%d", value); }
    static void append(rt_string& to, unsigned int value) { print(to, "%u", value); }
    static void append(rt_string& to, double value) { print(to, "%g", value); }

private:
    template <class T>
    static void print(rt_string& to, const char* format, T value) {
        char text[32];
        to.append(text, static_cast<std::size_t>(std::snprintf(text, sizeof text, format, value)));
    }
};

/** False if real-time memory is used up; the result then has what fitted. */
template <class T>
bool appendInPool(const void*, const void* const* arguments, void* result) {
    auto& text = *static_cast<rt_string*>(result);
    try {
        text = *static_cast<const rt_string*>(arguments[0]);
        Print::append(text, *static_cast<const T*>(arguments[1]));
        return true;
    } catch (const std::bad_alloc&) {
        return false;
    }
}

template <class T>
constexpr OperatorRow appendRow() {
    return {"+", &typeRef<rt_string>, &typeRef<rt_string>, &typeRef<T>, &appendInPool<T>};
}

constexpr OperatorRow appendsInPool[] = {
    appendRow<rt_string>(), appendRow<std::string>(), appendRow<int>(),  appendRow<unsigned int>(),
    appendRow<double>(),    appendRow<float>(),       appendRow<bool>(), appendRow<char>(),
};

}  // namespace

void addTextOperators() {
    operators()->add(appendsInPool, sizeof appendsInPool / sizeof appendsInPool[0]);
    addComparisons<rt_string>();
    operators()->add(appends, sizeof appends / sizeof appends[0]);
    addComparisons<std::string>();
    addComparisons<char>();
    addComparisons<FlowStatus>();
    addComparisons<WriteStatus>();
    addComparisons<SendStatus>();
}

}  // namespace RTT::types::builtin
