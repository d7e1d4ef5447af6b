// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OPERATOR_TYPES_HPP
#define ORO_OPERATOR_TYPES_HPP

#include <rtt/internal/mystd.hpp>
#include "Operators.hpp"
#include <functional>

namespace RTT {
namespace types {

/** For operators()->add(): an operator from a function or function object such as std::negate<T>(). */
template <class F>
UnaryOp* newUnaryOperator(const char* op, F function) {
    return new UnaryOp{op, eraseFunction(std::move(function))};
}

/** The same with two operands, such as std::plus<T>(). */
template <class F>
BinaryOp* newBinaryOperator(const char* op, F function) {
    return new BinaryOp{op, eraseFunction(std::move(function))};
}

/** The same with three operands; std::ternary_function is a base for such function objects. */
template <class F>
TernaryOp* newTernaryOperator(const char* op, F function) {
    return new TernaryOp{op, eraseFunction(std::move(function))};
}

/** A part computed by a function of the value. */
template <class F>
DotOp* newDotOperator(const char* name, F function) {
    return new DotOp{name, eraseFunction(std::move(function))};
}

}  // namespace types
}  // namespace RTT

#endif
