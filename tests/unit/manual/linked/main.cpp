// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// An executable that static libraries of components are linked into: deploys the file it is given, imports nothing.
#include <ocl/DeploymentComponent.hpp>
#include <rtt/os/main.h>

#include <iostream>

int ORO_main(int argc, char** argv) {
    OCL::DeploymentComponent deployer;
    deployer.displayComponentTypes();
    if (argc != 2 || !deployer.kickStart(argv[1])) return 1;
    for (const std::string& name : deployer.getPeerList()) std::cout << name << "\n";
    return 0;
}
