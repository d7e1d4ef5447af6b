// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The connections between the members of a chain.
#ifndef OROFORGE_CHAIN_DATA_FLOW_HPP
#define OROFORGE_CHAIN_DATA_FLOW_HPP

#include "peers.hpp"

#include <string>
#include <vector>

namespace OCL::chain {

struct Flow {
    std::size_t from, to;       // numbers of members
    std::string output, input;  // ports, with the services in which they are
    /** A value reaches its reader in the next cycle only. */
    bool isDelayed() const { return from >= to; }
};

std::vector<Flow> flowsOf(const std::vector<Peer>& members);

/** "c.out → a.in" */
std::string textOf(const Flow& flow, const std::vector<Peer>& members);

/** The order and the flows, for Graphviz. */
std::string dotOf(const std::string& chain, const std::vector<Peer>& members);

}  // namespace OCL::chain

#endif
