// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Makes state machines from their trees.
#ifndef ORO_SCRIPTING_DETAIL_MACHINE_BUILD_HPP
#define ORO_SCRIPTING_DETAIL_MACHINE_BUILD_HPP

#include <rtt/scripting/StateMachine.hpp>
#include <rtt/scripting/detail/compile/definitions.hpp>

namespace RTT::scripting::detail {

/** Checks that states, transitions and sub machines fit together; reports all errors to `*where.sink`. makeMachine()
    resolves the names in programs and conditions. */
bool checkMachineType(const MachineType& type, const MachineTypes& known, const CompileContext& where);

/** Checks that the type is known and each of its parameters is given once. */
bool checkInstance(const ast::Instance& instance, const MachineTypes& known, const oroforge::diag::FileName& file,
                   const CompileContext& where);

/**
 * Makes the machine and its sub machines, without loading them into the engine. The component gets its service, because
 * its programs may refer to that. If it cannot be made, reports all errors to `*where.sink` and returns null. `file` is
 * the file of `root`.
 */
StateMachinePtr makeMachine(const ast::Instance& root, const MachineTypes& known, const SourceFile& file,
                            const CompileContext& where);

}  // namespace RTT::scripting::detail

#endif
