// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <ocl/DeploymentComponent.hpp>
#include <rtt/Component.hpp>

namespace {
const RTT::ComponentFactoryLoader<OCL::DeploymentComponent> deployer("OCL::DeploymentComponent");
}  // namespace
