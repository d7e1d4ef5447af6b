// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_COMPONENT_NAME_HPP
#define OROFORGE_DEPLOYMENT_COMPONENT_NAME_HPP

#include <string>

namespace OCL::deploy {

/** Why a component cannot have that name; empty if it can. Log lines and names of files contain names of components. */
std::string nameFault(const std::string& name);

/** The text without control characters, for messages. */
std::string printableName(const std::string& name);

}  // namespace OCL::deploy

#endif
