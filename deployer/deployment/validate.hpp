// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What can be told about a plan before anything is created.
#ifndef OROFORGE_DEPLOYMENT_VALIDATE_HPP
#define OROFORGE_DEPLOYMENT_VALIDATE_HPP

#include "plan.hpp"

#include <diag/sink.hpp>
#include <rtt/internal/ComponentDescription.hpp>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace OCL::deploy {

/** What the plan can refer to, after its imports have been done. */
struct Surroundings {
    std::string deployer;                 // its own name; "this" means the same
    std::vector<std::string> components;  // that exist already
    std::set<std::string> connections;    // in which ports of these take part
    std::vector<const Plan*> planned;     // before this one, and not applied
    std::vector<std::string> componentTypes;
    std::map<std::string, const RTT::internal::ComponentDescription*> descriptions;  // of those that have one
    std::vector<std::string> services;                                               // that can be loaded
    bool planOnly = false;  // the plan will not be applied: nobody looks at the components themselves
};

/** Reports every name that is used twice or refers to nothing, and every file that is missing. */
void validate(const Plan& plan, const Surroundings& surroundings, diag::Sink& sink);

/** True if the component is there already, the deployer itself included. */
bool exists(const ComponentPlan& component, const Surroundings& surroundings);
/** True if the struct adds options to a component that exists, or that a plan before this one has. */
bool addsOptions(const ComponentPlan& component, const Surroundings& surroundings);

}  // namespace OCL::deploy

#endif
