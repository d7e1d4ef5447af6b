// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Functions, programs, RootMachine and SubMachine.
#ifndef ORO_SCRIPTING_DETAIL_PARSE_DEFINITION_HPP
#define ORO_SCRIPTING_DETAIL_PARSE_DEFINITION_HPP

#include <rtt/scripting/detail/syntax/parse_rules.hpp>

namespace RTT::scripting::detail {

class DefinitionParser : private Rules {
public:
    explicit DefinitionParser(Grammar& grammar) : Rules(grammar) {}

    ast::Function function();
    ast::Program program();
    /** `RootMachine T n(p = 1)`, and the same with SubMachine. */
    ast::Instance instance();

private:
    void functionArguments(ast::Function& function);
    void instanceArguments(ast::Instance& instance);
};

}  // namespace RTT::scripting::detail

#endif
