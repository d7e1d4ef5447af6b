// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_FORESEEN_GRAPH_HPP
#define OROFORGE_DEPLOYMENT_FORESEEN_GRAPH_HPP

#include "session.hpp"

#include <string>

namespace OCL::deploy {

/** Lines of a graph: what scripts would add to the components that are there. Dotted: what they might add; in a note: what
    they compute. */
std::string foreseenGraphOf(const Session& session);

}  // namespace OCL::deploy

#endif
