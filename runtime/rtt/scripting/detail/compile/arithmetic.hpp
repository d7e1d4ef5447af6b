// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The operators and conversions of the built-in types as instructions. They agree with the operators and constructors
// that the built-in typekit registers for these types.
#ifndef ORO_SCRIPTING_DETAIL_ARITHMETIC_HPP
#define ORO_SCRIPTING_DETAIL_ARITHMETIC_HPP

#include <rtt/scripting/detail/execute/code.hpp>
#include <rtt/scripting/detail/compile/kinds.hpp>

#include <string>

namespace RTT::scripting::detail {

struct Operation {
    Action act = nullptr;  ///< null: these types have no such operator
    Kind result = Kind::None;
};

/** `*to = *a op *b`; both operands are of that kind. */
Operation binaryOperation(const std::string& op, Kind kind);
/** `*to = op *a`. */
Operation unaryOperation(char op, Kind kind);

inline bool isReal(Kind kind) { return kind == Kind::Float || kind == Kind::Double; }

enum class Conversion { None, Silent, Warned };

/** Whether, and how, a value of one kind converts implicitly to another. */
Conversion conversion(Kind from, Kind to);
/** `*to = *a`; null if there is no conversion. */
Action conversionAction(Kind from, Kind to);
/** Converts at once. */
void convertValue(Kind from, const void* a, Kind to, void* b);

}  // namespace RTT::scripting::detail

#endif
