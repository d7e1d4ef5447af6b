// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What can be told about a plan before anything is created.
#ifndef OROFORGE_DEPLOYMENT_VALIDATE_HPP
#define OROFORGE_DEPLOYMENT_VALIDATE_HPP

#include "plan.hpp"

#include <diag/sink.hpp>

#include <string>
#include <vector>

namespace OCL::deploy {

/** What the plan can refer to, after its imports have been done. */
struct Surroundings {
    std::string deployer;                 // its own name; "this" means the same
    std::vector<std::string> components;  // that exist already
    std::vector<std::string> componentTypes;
    std::vector<std::string> services;  // that can be loaded
};

/** Reports every name that is used twice or refers to nothing, and every file that is missing. */
void validate(const Plan& plan, const Surroundings& surroundings, diag::Sink& sink);

/** True if the struct adds options to a component that exists or is described by another struct. */
bool addsOptions(const ComponentPlan& component, const Surroundings& surroundings);

}  // namespace OCL::deploy

#endif
