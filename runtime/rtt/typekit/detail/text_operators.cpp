// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "builtin_parts.hpp"
#include "operator_rows.hpp"

#include <rtt/FlowStatus.hpp>
#include <rtt/SendStatus.hpp>
#include <sstream>
#include <string>

namespace RTT {
namespace types {
namespace builtin {

namespace {

/** Text and the text form of a value. Allocates. */
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

}  // namespace

void addTextOperators() {
    operators()->add(appends, sizeof appends / sizeof appends[0]);
    addComparisons<std::string>();
    addComparisons<char>();
    addComparisons<FlowStatus>();
    addComparisons<WriteStatus>();
    addComparisons<SendStatus>();
}

}  // namespace builtin
}  // namespace types
}  // namespace RTT
