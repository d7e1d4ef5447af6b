// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The parts of a DeploymentComponent.
#ifndef OROFORGE_DEPLOYMENT_PARTS_HPP
#define OROFORGE_DEPLOYMENT_PARTS_HPP

#include <ocl/DeploymentComponent.hpp>

#include "deployed_files.hpp"
#include "named_components.hpp"
#include "wiring.hpp"

namespace OCL {

struct DeploymentComponent::Impl {
    deploy::Session session;
    deploy::NamedComponents components{session};
    deploy::Wiring wiring{session};
    deploy::DeployedFiles files{session};

    Purpose purpose = Purpose::Deploy;
    bool siteFileFailed = false;
    // The values of properties and attributes.
    std::string componentPath, target;
    bool autoUnload = true;
};

}  // namespace OCL

#endif
