// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_CHECK_PROPERTIES_HPP
#define OROFORGE_DEPLOYMENT_CHECK_PROPERTIES_HPP

#include <diag/sink.hpp>

namespace OCL::deploy {

namespace diag = oroforge::diag;
struct Session;

/**
 * Reports properties that structs name and components of the group do not have, and such members of properties, also
 * those in property files. Other properties in files are reported only if they seem to be misspelt, because a file may
 * be for several components.
 */
void checkProperties(const Session& session, int group, diag::Sink& sink);

}  // namespace OCL::deploy

#endif
