// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Checks a plan before anything is created.
#ifndef OROFORGE_DEPLOYMENT_VALIDATE_HPP
#define OROFORGE_DEPLOYMENT_VALIDATE_HPP

#include "plan.hpp"
#include "property_files.hpp"

#include <diag/sink.hpp>
#include <rtt/internal/ComponentDescription.hpp>

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace OCL::deploy {

/** What a plan may refer to after its imports. */
struct PlanContext {
    std::string deployer;                 // its name; "this" means the same
    std::vector<std::string> components;  // existing components
    std::set<std::string> connections;    // connections of their ports
    std::vector<const Plan*> planned;     // earlier plans that are not applied
    std::vector<std::string> componentTypes;
    std::map<std::string, const RTT::internal::ComponentDescription*> descriptions;  // of types that have one
    std::vector<std::string> services;                                               // services that can be loaded
    bool serves = false;                                                             // components can have servers
    std::function<std::string(const std::string&)> luaFault;  // what is wrong with a file of Lua code
    bool planOnly = false;  // the plan will not be applied, so the components will not exist
    std::shared_ptr<PropertyFiles> propertyFiles = std::make_shared<PropertyFiles>();
};

/** Reports each name that is used twice or refers to nothing, and each missing file. */
void validate(const Plan& plan, const PlanContext& context, diag::Sink& sink);

/** True if the component exists already or is the deployer itself. */
bool exists(const ComponentPlan& component, const PlanContext& context);
/** True if the struct adds options to a component that exists or that an earlier plan has. */
bool addsOptions(const ComponentPlan& component, const PlanContext& context);

}  // namespace OCL::deploy

#endif
