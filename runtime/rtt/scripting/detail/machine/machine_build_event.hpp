// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_MACHINE_BUILD_EVENT_HPP
#define ORO_SCRIPTING_DETAIL_MACHINE_BUILD_EVENT_HPP

#include <rtt/internal/dotted_name.hpp>
#include <rtt/scripting/detail/machine/machine_build_transition.hpp>
#include <rtt/scripting/detail/machine/machine_event.hpp>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace RTT::scripting::detail {

/** Adds the transitions of one machine. Builds those that wait for a call of an operation or for new data on a port; a
    TransitionBuilder builds the others. */
class EventBuilder {
public:
    EventBuilder(const CompileContext& where, MachineModel& model, const TransitionBuilder& transitions)
        : where_(where), model_(model), transitions_(transitions) {}

    /** Adds the transition to `to`, or to the events of the machine, which it takes in `state` (null: in all). */
    void add(const ast::Transition& tree, const Scope& scope, std::vector<MachineTransition>& to,
             const MachineState* state);
    /** True if the machine has events. */
    bool hasEvents() const { return !listening_.empty(); }
    /** Begins to put calls into the queue. */
    void listen(const std::shared_ptr<EventQueue>& queue) const;

private:
    struct Listening {
        OperationEvent* event;
        std::shared_ptr<internal::SignalBase> signal;
    };
    oroforge::diag::Location at(ast::Place place) const { return {where_.file, place.line, place.column}; }
    void error(ast::Place place, const char* code, const std::string& message) const {
        where_.sink->error(at(place), code, message);
    }
    internal::NamedObject sourceOf(const ast::Transition& tree) const;
    void unknownEvent(const ast::Transition& tree, const internal::NamedObject& source) const;
    GuardPtr portGuard(const ast::Transition& tree, base::InputPortInterface& port, const Scope& scope);
    void refuseOperation(const ast::Transition& tree) const;
    void addOperationEvent(const ast::Transition& tree, OperationInterfacePart& operation, const Scope& scope,
                           const MachineState* state);
    ActionPtr assignment(const ast::Expression& to, const base::DataSourceBase::shared_ptr& from,
                         const Scope& scope) const;

    const CompileContext& where_;
    MachineModel& model_;
    const TransitionBuilder& transitions_;
    std::map<base::InputPortInterface*, std::shared_ptr<PortReader>> readers_;
    std::vector<Listening> listening_;
};

}  // namespace RTT::scripting::detail

#endif
