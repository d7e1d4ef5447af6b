// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The value of an expression while code is made of it.
#ifndef ORO_SCRIPTING_DETAIL_OPERAND_HPP
#define ORO_SCRIPTING_DETAIL_OPERAND_HPP

#include <rtt/base/DataSourceBase.hpp>
#include <rtt/scripting/detail/syntax/ast.hpp>
#include <rtt/scripting/detail/compile/kinds.hpp>

namespace RTT::scripting::detail {

/**
 * Either where the value is once the code before has been executed (`address`, direct kinds only), or a source that gives
 * it when it is evaluated, which whoever uses the operand sees to; or both, of a variable.
 */
struct Operand {
    Kind kind = Kind::None;
    const void* address = nullptr;
    base::DataSourceBase::shared_ptr source;
    bool constant = false;  ///< the value at `address` does not change
    bool computed = false;  ///< an instruction writes it to where nothing else does: a cell at `address`, or `source`
    bool sent = false;      ///< what send() gives; its type has no name
    ast::Place at;

    /** A variable, or part of one, that can be assigned to. */
    bool assignable() const { return source && source->isAssignable(); }
};

/** Of a type that widened() knows. */
bool isSmallNumber(const Operand& operand);

/** Of a type whose values have names. */
bool isEnum(const types::TypeInfo* type);

/** The type's name for messages. */
std::string typeName(const Operand& operand);

/** Where the value of a source of a direct kind always is; null if it has to be evaluated for that. */
const void* fixedAddress(base::DataSourceBase& source, Kind kind);

}  // namespace RTT::scripting::detail

#endif
