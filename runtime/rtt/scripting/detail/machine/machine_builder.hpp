// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_MACHINE_BUILDER_HPP
#define ORO_SCRIPTING_DETAIL_MACHINE_BUILDER_HPP

#include <rtt/scripting/detail/machine/machine_build.hpp>
#include <rtt/scripting/detail/machine/machine_build_event.hpp>
#include <rtt/scripting/detail/machine/machine_service.hpp>

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
    void makeService();
    void declare();
    void declare(const std::vector<const ast::Statement*>& statements, Scope& scope);
    bool hasConstants() const;
    void assignParameters();
    void makeSubMachines();
    void makeStates();
    void fillState(const ast::State& tree, MachineState& state);

    const ast::Instance& instance_;
    const Context& context_;
    const MachineType& type_;
    const ast::StateMachine& tree_;
    CompileContext where_;  // for the text of the type
    Scope scope_;
    MachineSlot slot_;
    std::unique_ptr<MachineModel> model_;
    TransitionBuilder transitions_;
    EventBuilder events_;
    std::vector<std::unique_ptr<Scope>> state_scopes_;  // each sees those of earlier states
};

}  // namespace RTT::scripting::detail

#endif
