// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_CHECK_PROPERTIES_HPP
#define OROFORGE_DEPLOYMENT_CHECK_PROPERTIES_HPP

#include "records.hpp"

#include <diag/sink.hpp>

namespace OCL::deploy {

/**
 * Reports what a component is to be given and has not: properties that its structs name, and members of properties, also those
 * in its property files. Properties of files that it does not have are told only if they seem to be misspelt: a file may be for
 * several components.
 */
void checkProperties(const Record& record, const RTT::TaskContext* deployer, diag::Sink& sink);

}  // namespace OCL::deploy

#endif
