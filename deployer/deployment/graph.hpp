// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_GRAPH_HPP
#define OROFORGE_DEPLOYMENT_GRAPH_HPP

#include "session.hpp"

#include <string>

namespace OCL::deploy {

/** The components, with their connections and peers, in the language of Graphviz. Components that are only planned have
    connections without direction, because their ports are not known. */
std::string graphOf(const Session& session);

}  // namespace OCL::deploy

#endif
