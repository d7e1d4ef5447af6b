// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_SCRIPT_CONTENTS_HPP
#define ORO_SCRIPTING_DETAIL_SCRIPT_CONTENTS_HPP

#include <rtt/scripting/detail/syntax/ast.hpp>
#include <rtt/scripting/script_syntax.hpp>

#include <string>

namespace RTT::scripting::detail {

/** Calls `error(place, code, message)` for everything that such a script may not have. */
template <class Items, class Error>
void checkContents(const Items& items, Contents contents, Error error) {
    if (contents == Contents::Everything) return;
    const bool programs = contents == Contents::Programs;
    const char* const what[] = {"a statement", "a function", "a program", "a type of state machines",
                                "a state machine"};
    bool machines = false;
    for (const ast::Item& item : items) {
        const std::size_t index = item.what.index();
        const bool allowed = programs ? index == 1 || index == 2 : index == 3 || index == 4;
        machines = machines || index == 4;
        if (!allowed)
            error(item.at, "OPS412",
                  std::string("found ") + what[index] + ", expected " +
                      (programs ? "functions and programs" : "state machines") + " only; runScript takes everything");
    }
    if (!programs && !machines) error(ast::Place{}, "OPS413", "found no RootMachine, expected at least one");
}

}  // namespace RTT::scripting::detail

#endif
