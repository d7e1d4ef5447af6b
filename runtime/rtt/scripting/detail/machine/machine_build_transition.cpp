// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/machine/machine_builder.hpp>

namespace RTT::scripting::detail {

MachineSelection MachineBuilder::selection(const ast::Selection& tree, const Scope& scope) {
    MachineSelection made;
    made.program = program(tree.program, "the program of a transition", scope);
    for (const ast::Identifier& name : tree.states) {
        const auto found = states_.find(name.text);
        if (found != states_.end()) made.states.push_back(found->second);
    }
    return made;
}

MachineTransition MachineBuilder::transition(const ast::Transition& tree, const Scope& scope) {
    MachineTransition made;
    made.at = tree.at;
    if (tree.condition) made.condition = guard(*tree.condition, scope);
    made.then = selection(tree.selection, scope);
    if (tree.otherwise) made.otherwise = std::make_unique<MachineSelection>(selection(*tree.otherwise, scope));
    return made;
}

void MachineBuilder::addTransition(const ast::Transition& tree, const Scope& scope, std::vector<MachineTransition>& to,
                                   const MachineState* state) {
    if (tree.event.empty()) {
        to.push_back(transition(tree, scope));
        return;
    }
    const Source source = sourceOf(tree);
    if (!source.service) return;
    const std::string& name = tree.event.back().text;
    if (auto* const port = source.service->getPortType<base::InputPortInterface>(name)) {
        MachineTransition made = transition(tree, scope);
        made.event = portGuard(tree, *port, scope);
        to.push_back(std::move(made));
    } else if (OperationInterfacePart* const operation = source.service->getPart(name)) {
        addOperationEvent(tree, *operation, scope, state);
    } else {
        unknownEvent(tree, source);
    }
}

}  // namespace RTT::scripting::detail
