// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_DESCRIBED_VALUES_HPP
#define OROFORGE_DEPLOYMENT_DESCRIBED_VALUES_HPP

#include "plan.hpp"
#include "property_files.hpp"

#include <diag/sink.hpp>
#include <rtt/internal/ComponentDescription.hpp>

namespace OCL::deploy {

/** Checks the values in a component's structs and property files by setting properties of the described types. */
void checkDescribedValues(const ComponentPlan& component, const RTT::internal::ComponentDescription& description,
                          PropertyFiles& files, diag::Sink& sink);

}  // namespace OCL::deploy

#endif
