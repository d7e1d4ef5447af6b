// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Loads, converts, copies and stores values.
#ifndef ORO_SCRIPTING_DETAIL_COMPILE_VALUE_HPP
#define ORO_SCRIPTING_DETAIL_COMPILE_VALUE_HPP

#include <rtt/scripting/detail/compile/unit_part.hpp>

namespace RTT::scripting::detail {

class ValueCompiler : private UnitPart {
public:
    explicit ValueCompiler(UnitCompiler& unit) : UnitPart(unit) {}

    Operand fromSource(Source source, ast::Place at);
    /** A source of the value. */
    Source sourceOf(const Operand& operand);
    /** The value that an instruction computes. */
    Operand computedBy(Action act, const void* a, const void* b, Kind kind, ast::Place at);
    /** Loads the value to an address. Direct kinds only. */
    Operand load(Operand operand);
    /** Loads and converts the value. */
    Operand loadAs(Operand operand, Kind kind, bool warns = true);
    /** Widens a small number to a kind with which instructions compute; leaves others as they are. */
    Operand promoted(Operand operand);
    /** A copy of the value, taken before the instructions from `at` on, which belong to the present expression. */
    Operand copied(const Operand& value, std::size_t at);
    /** As copied(), also for values that are evaluated only when they are used. */
    Operand taken(const Operand& value, std::size_t at);
    /** Assigns a value, converted if needed. `what` is for messages: "variable 'x'". */
    void store(const Operand& to, Operand value, const std::string& what);
    /** Evaluates it for its effects. */
    void discard(const Operand& operand);

private:
    /** The value has the kind of `to`. False if `to` cannot be assigned. */
    bool storeDirect(const Operand& to, const Operand& value);
};

}  // namespace RTT::scripting::detail

#endif
