// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_SHUTDOWN_HPP
#define OROFORGE_DEPLOYMENT_SHUTDOWN_HPP

#include <string>
#include <vector>

namespace RTT {
class TaskContext;
}

namespace OCL::deploy {

/** The properties that users may give the deployer to control its shutdown. */
std::vector<std::string> shutdownProperties();

/** Tells the component "Application", or another that a property names, to end, and waits for it. */
void shutDownApplication(RTT::TaskContext& deployer);

}  // namespace OCL::deploy

#endif
