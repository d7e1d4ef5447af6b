// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_MACHINE_BUILD_TRANSITION_HPP
#define ORO_SCRIPTING_DETAIL_MACHINE_BUILD_TRANSITION_HPP

#include <rtt/scripting/detail/machine/machine_code.hpp>

#include <map>
#include <string>

namespace RTT::scripting::detail {

/** Builds the transitions of one machine, apart from events. */
class TransitionBuilder {
public:
    explicit TransitionBuilder(const CompileContext& where) : where_(where) {}

    /** Before the first transition. */
    void addState(MachineState& state) { states_[state.name] = &state; }
    MachineTransition build(const ast::Transition& tree, const Scope& scope) const;

private:
    MachineSelection selection(const ast::Selection& tree, const Scope& scope) const;

    const CompileContext& where_;
    std::map<std::string, MachineState*> states_;
};

}  // namespace RTT::scripting::detail

#endif
