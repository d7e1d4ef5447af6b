// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/machine/machine_build_transition.hpp>

namespace RTT::scripting::detail {

MachineSelection TransitionBuilder::selection(const ast::Selection& tree, const Scope& scope) const {
    MachineSelection made;
    made.program = makeProgram(tree.program, "the program of a transition", scope, where_);
    for (const ast::Identifier& name : tree.states) {
        const auto found = states_.find(name.text);
        if (found != states_.end()) made.states.push_back(found->second);
    }
    return made;
}

MachineTransition TransitionBuilder::build(const ast::Transition& tree, const Scope& scope) const {
    MachineTransition made;
    made.at = tree.at;
    if (tree.condition) made.condition = makeGuard(*tree.condition, scope, where_);
    made.then = selection(tree.selection, scope);
    if (tree.otherwise) made.otherwise = std::make_unique<MachineSelection>(selection(*tree.otherwise, scope));
    return made;
}

}  // namespace RTT::scripting::detail
