// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_MISSING_TYPEKITS_HPP
#define OROFORGE_DEPLOYMENT_MISSING_TYPEKITS_HPP

#include "plan.hpp"

#include <diag/sink.hpp>
#include <rtt/internal/ComponentDescription.hpp>

#include <map>
#include <set>
#include <string>
#include <typeinfo>
#include <vector>

namespace OCL::deploy {

/** Advice about a type that no loaded typekit has: names the installed packages whose typekits have it. Reads libraries
    but loads none. */
std::string typekitAdvice(const std::type_info& type);

/** Reports types of described ports that no loaded typekit has, each once, if an installed typekit has the type or if
    the plan asks for a transport, which needs a typekit. Connections within a process work without. */
class MissingTypekits {
public:
    MissingTypekits(const Plan& plan, diag::Sink& sink) : plan_(plan), sink_(sink) {}
    void check(const ComponentPlan& component, const RTT::internal::ComponentDescription& description);

private:
    bool isTransported(const PortPlan& port) const;
    const std::vector<std::string>& packagesOf(const std::type_info& type);

    const Plan& plan_;
    diag::Sink& sink_;
    std::set<std::string> reported_;                         // names of types
    std::map<std::string, std::vector<std::string>> found_;  // packages, by the name of the type
};

}  // namespace OCL::deploy

#endif
