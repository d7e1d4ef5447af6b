// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_SHUTDOWN_HPP
#define OROFORGE_DEPLOYMENT_SHUTDOWN_HPP

#include <string>
#include <vector>

namespace OCL::deploy {

/** The properties that users may give the deployer to control DeploymentComponent::shutdownDeployment(). */
std::vector<std::string> shutdownProperties();

}  // namespace OCL::deploy

#endif
