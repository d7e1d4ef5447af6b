// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The service of a state machine in its component.
#ifndef ORO_SCRIPTING_DETAIL_MACHINE_SERVICE_HPP
#define ORO_SCRIPTING_DETAIL_MACHINE_SERVICE_HPP

#include <rtt/Service.hpp>
#include <rtt/scripting/StateMachine.hpp>
#include <rtt/scripting/detail/compile/compiler.hpp>

#include <boost/weak_ptr.hpp>

namespace RTT::scripting::detail {

/** The machine on which operations work; null before it is made and after it is destroyed. */
typedef std::shared_ptr<boost::weak_ptr<StateMachine>> MachineSlot;

/** Adds commands and queries. Without a machine they return false and empty texts. */
void addMachineOperations(Service& service, const MachineSlot& slot);
/** Adds variables and constants as attributes. */
void addMachineValues(Service& service, const Scope& scope);

}  // namespace RTT::scripting::detail

#endif
