// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Chains: components that execute others, their members, in an order. Their type is in a component library, so they are
// known here by their interface: the property sched_order, and the operation describe().
#ifndef OROFORGE_DEPLOYMENT_CHAINS_HPP
#define OROFORGE_DEPLOYMENT_CHAINS_HPP

#include "activities.hpp"
#include "session.hpp"

#include <string>
#include <vector>

namespace OCL::deploy {

/** The type of chains that the deployer makes itself. */
constexpr const char* kChainType = "OCL::Chain";

/** Makes the components that `Members` of the records name slaves of these, and sets their order. */
void setMembers(Session& session, const std::vector<ComponentRecord*>& records, diag::Sink& sink);

/** Makes a chain, unless there is a component of that name, gives it a thread, makes the members its slaves and sets
    the order. "*" is allowed among the members. False, with the reason; a chain that it made is then gone. */
bool makeChain(Session& session, const std::string& name, const ActivityNumbers& numbers,
               const std::vector<std::string>& members, std::string& error);

/** What the chains say of their order, thread and delays; for files that are only checked, what the files say. */
std::string chainsOf(const Session& session);

// planned_chains.cpp
std::string plannedChainsOf(const Session& session);

}  // namespace OCL::deploy

#endif
