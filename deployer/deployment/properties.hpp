// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_PROPERTIES_HPP
#define OROFORGE_DEPLOYMENT_PROPERTIES_HPP

#include "records.hpp"

#include <diag/sink.hpp>

namespace OCL::deploy {

/** Sets the component's properties, and gives those for its end to the deployer if it is that: what the deployment file says, then the property files in their order. */
void applyProperties(Record& record, const RTT::TaskContext* deployer, diag::Sink& sink);

/** Writes all properties to the last file they were loaded from, if the component is to be saved. */
void autoSave(const Record& record);

/** Sets global properties of the process. */
void applyGlobals(const std::vector<xml::Element>& globals, diag::Sink& sink);

}  // namespace OCL::deploy

#endif
