// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The value of an expression during compilation.
#ifndef ORO_SCRIPTING_DETAIL_OPERAND_HPP
#define ORO_SCRIPTING_DETAIL_OPERAND_HPP

#include <rtt/base/DataSourceBase.hpp>
#include <rtt/scripting/detail/syntax/ast.hpp>
#include <rtt/scripting/detail/compile/kinds.hpp>

namespace RTT::scripting::detail {

/**
 * Either the `address` of the value, valid when the code compiled so far has run (direct kinds only: those that
 * instructions work on), or a `source`, which the user of the operand must evaluate; a variable has both.
 */
struct Operand {
    Kind kind = Kind::None;
    const void* address = nullptr;
    base::DataSourceBase::shared_ptr source;
    bool constant = false;  ///< the value at `address` does not change
    bool computed = false;  ///< only one instruction writes it: to a cell at `address`, or to `source`
    bool sent = false;      ///< the result of send(), whose type no typekit has
    ast::Place at;

    /** True for a variable, or part of one, that can be assigned. */
    bool assignable() const { return source && source->isAssignable(); }
};

/** True for a number that is computed as one of a larger type, such as short: see widened(). */
bool isSmallNumber(const Operand& operand);

/** True for an enumeration. */
bool isEnum(const types::TypeInfo* type);

/** The type's name for messages. */
std::string typeName(const Operand& operand);

/** The constant address of the value of a source of a direct kind; null if it must be evaluated. */
const void* fixedAddress(base::DataSourceBase& source, Kind kind);

}  // namespace RTT::scripting::detail

#endif
