// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What programs with CORBA have in common.
#ifndef OROFORGE_DEPLOYER_CORBA_PROGRAM_HPP
#define OROFORGE_DEPLOYER_CORBA_PROGRAM_HPP

#include "program.hpp"

namespace OCL::deploy {

/** A deployer that other processes can use; the words are arguments of the ORB. */
std::unique_ptr<DeploymentComponent> makeCorbaDeployer(const Options& options, std::vector<char*>& words);
/** Stays until a signal comes, or another process calls the operation "shutdown". */
bool stayForOthers(DeploymentComponent& deployer, SignalCatcher& ending, const Options& options, bool deployed);
/** Ends the ORB. */
void endCorba();

}  // namespace OCL::deploy

#endif
