// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_CHECK_PROPERTIES_HPP
#define OROFORGE_DEPLOYMENT_CHECK_PROPERTIES_HPP

#include <diag/sink.hpp>

namespace OCL::deploy {

namespace diag = oroforge::diag;
struct Session;

/**
 * Reports what the components of a group are to be given and have not: properties that their structs name, and members of
 * properties, also those in their property files. Properties of files that a component does not have are told only if they seem
 * to be misspelt: a file may be for several components.
 */
void checkProperties(const Session& session, int group, diag::Sink& sink);

}  // namespace OCL::deploy

#endif
