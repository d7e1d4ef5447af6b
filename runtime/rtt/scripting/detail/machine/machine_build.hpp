// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// From the tree of a state machine to one that can be executed.
#ifndef ORO_SCRIPTING_DETAIL_MACHINE_BUILD_HPP
#define ORO_SCRIPTING_DETAIL_MACHINE_BUILD_HPP

#include <rtt/scripting/StateMachine.hpp>
#include <rtt/scripting/detail/compile/definitions.hpp>

namespace RTT::scripting::detail {

/** Whether states, transitions and sub machines fit together. False, with all errors in `*where.sink`, if they do not. The names
    in programs and conditions are looked up by makeMachine(). */
bool checkMachineType(const MachineType& type, const MachineTypes& known, const Surroundings& where);

/** Whether the type is known, and each of its parameters is given once. */
bool checkInstance(const ast::Instance& instance, const MachineTypes& known, const oroforge::diag::FileName& file,
                   const Surroundings& where);

/**
 * The machine and its sub machines, not loaded into the engine. Its service is one of the component from then on, since its
 * programs may refer to it. Null, with all errors in `*where.sink`, if it cannot be made. `file` is that of `root`.
 */
StateMachinePtr makeMachine(const ast::Instance& root, const MachineTypes& known, const SourceFile& file,
                            const Surroundings& where);

}  // namespace RTT::scripting::detail

#endif
