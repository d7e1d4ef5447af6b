// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_GRAPH_HPP
#define OROFORGE_DEPLOYMENT_GRAPH_HPP

#include "session.hpp"

#include <string>

namespace OCL::deploy {

/** The components, connections and peers as a graph for Graphviz. Connections of planned components have no direction,
    because their ports are unknown. */
std::string graphOf(const Session& session);

}  // namespace OCL::deploy

#endif
