// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_PROPERTIES_HPP
#define OROFORGE_DEPLOYMENT_PROPERTIES_HPP

#include "session.hpp"

namespace OCL::deploy {

/** Sets the component's properties by the deployment file, then by the property files in order. If the component is the
deployer, adds the properties for its shutdown. */
void applyProperties(const Session& session, ComponentRecord& record, diag::Sink& sink);

/** Writes all properties to the file from which they were last loaded, if the component has AutoSave. */
void autoSave(const ComponentRecord& record);

/** Sets global properties of the process. */
void applyGlobals(const std::vector<xml::Element>& globals, diag::Sink& sink);

}  // namespace OCL::deploy

#endif
