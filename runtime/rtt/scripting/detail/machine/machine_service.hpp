// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The face of a state machine in its component.
#ifndef ORO_SCRIPTING_DETAIL_MACHINE_SERVICE_HPP
#define ORO_SCRIPTING_DETAIL_MACHINE_SERVICE_HPP

#include <rtt/Service.hpp>
#include <rtt/scripting/StateMachine.hpp>
#include <rtt/scripting/detail/compile/compiler.hpp>

#include <boost/weak_ptr.hpp>

namespace RTT::scripting::detail {

/** The machine that operations work on: there is none before it is made and after it is destroyed. */
typedef std::shared_ptr<boost::weak_ptr<StateMachine>> MachineSlot;

/** Commands and queries. Without a machine they return false and empty texts. */
void addMachineOperations(Service& service, const MachineSlot& slot);
/** Variables and constants as attributes. */
void addMachineValues(Service& service, const Scope& scope);

}  // namespace RTT::scripting::detail

#endif
