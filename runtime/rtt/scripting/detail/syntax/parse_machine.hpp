// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Types of state machines, and their states.
#ifndef ORO_SCRIPTING_DETAIL_PARSE_MACHINE_HPP
#define ORO_SCRIPTING_DETAIL_PARSE_MACHINE_HPP

#include <rtt/scripting/detail/syntax/parse_rules.hpp>

namespace RTT::scripting::detail {

class MachineParser : private Rules {
public:
    explicit MachineParser(Grammar& grammar) : Rules(grammar) {}

    ast::StateMachine parse();

private:
    void machineItem(ast::StateMachine& machine);
    ast::State state();
    void stateItem(ast::State& state);
    void stateProgram(ast::State& state);
    void preconditions(ast::State& state);
    void precondition(ast::State& state);
};

}  // namespace RTT::scripting::detail

#endif
