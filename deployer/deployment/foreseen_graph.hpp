// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_FORESEEN_GRAPH_HPP
#define OROFORGE_DEPLOYMENT_FORESEEN_GRAPH_HPP

#include "session.hpp"

#include <string>

namespace OCL::deploy {

/** The lines of a graph for what scripts would add to the existing components. What they might add is dotted; what they
    compute is in a note. */
std::string foreseenGraphOf(const Session& session);

}  // namespace OCL::deploy

#endif
