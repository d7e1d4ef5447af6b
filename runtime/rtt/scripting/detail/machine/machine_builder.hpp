// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_MACHINE_BUILDER_HPP
#define ORO_SCRIPTING_DETAIL_MACHINE_BUILDER_HPP

#include <rtt/scripting/detail/machine/machine_build.hpp>
#include <rtt/scripting/detail/machine/machine_event.hpp>
#include <rtt/scripting/detail/machine/machine_service.hpp>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace RTT::scripting::detail {

/**
 * Makes one machine, and by further builders its sub machines:
 *
 *     service      so that programs can name the machine itself
 *     variables    parameters, values of parameters, everything else that is declared
 *     sub machines
 *     states       programs, conditions, transitions
 *     machine      and then its events
 *
 * Each program and condition has its own compiler, because one may begin while another has yielded.
 */
class MachineBuilder {
public:
    /** The context of an instance. */
    struct Context {
        const MachineTypes& known;
        const Scope& scope;           ///< for the values of parameters
        const CompileContext& where;  ///< for the same
        Service& service;             ///< gets the service of the machine
        const MachineBuilder* outer;  ///< builds the outer machine; or null
    };

    MachineBuilder(const ast::Instance& instance, const Context& context);
    /** The machine; null if there was an error. */
    StateMachinePtr build();

private:
    bool isPartOfItself() const;
    oroforge::diag::Location at(ast::Place place) const { return {where_.file, place.line, place.column}; }
    void error(ast::Place place, const char* code, const std::string& message);

    // machine_builder.cpp
    void makeService();
    void declare();
    void declare(const std::vector<const ast::Statement*>& statements, Scope& scope);
    bool hasConstants() const;
    void assignParameters();
    void makeSubMachines();
    void makeStates();
    void fillState(const ast::State& tree, MachineState& state);
    /** A routine for the code; null if there is nothing to execute. */
    RoutinePtr routine(std::unique_ptr<Code> code, CodeRoutine::Pace pace) const;
    RoutinePtr program(const std::unique_ptr<ast::Block>& block, const std::string& name, const Scope& scope) const;
    GuardPtr guard(const ast::Expression& condition, const Scope& scope) const;

    // machine_build_transition.cpp
    MachineTransition transition(const ast::Transition& tree, const Scope& scope);
    MachineSelection selection(const ast::Selection& tree, const Scope& scope);
    void addTransition(const ast::Transition& tree, const Scope& scope, std::vector<MachineTransition>& to,
                       const MachineState* state);

    // machine_build_event.cpp
    struct Source {
        TaskContext* component = nullptr;
        Service::shared_ptr service;
    };
    struct Listening {
        OperationEvent* event;
        std::shared_ptr<internal::SignalBase> signal;
    };
    Source sourceOf(const ast::Transition& tree);
    void unknownEvent(const ast::Transition& tree, const Source& source);
    GuardPtr portGuard(const ast::Transition& tree, base::InputPortInterface& port, const Scope& scope);
    void refuseOperation(const ast::Transition& tree);
    void addOperationEvent(const ast::Transition& tree, OperationInterfacePart& operation, const Scope& scope,
                           const MachineState* state);
    ActionPtr assignment(const ast::Expression& to, const base::DataSourceBase::shared_ptr& from, const Scope& scope);

    const ast::Instance& instance_;
    const Context& context_;
    const MachineType& type_;
    const ast::StateMachine& tree_;
    CompileContext where_;  // for the text of the type
    Scope scope_;
    MachineSlot slot_;
    std::unique_ptr<MachineModel> model_;
    std::map<std::string, MachineState*> states_;
    std::map<base::InputPortInterface*, std::shared_ptr<PortReader>> readers_;
    std::vector<Listening> listening_;
    std::vector<std::unique_ptr<Scope>> state_scopes_;  // each sees those of earlier states
};

}  // namespace RTT::scripting::detail

#endif
