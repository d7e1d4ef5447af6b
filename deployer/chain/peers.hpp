// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The peers of a chain, and the order of those that are its members.
#ifndef OROFORGE_CHAIN_PEERS_HPP
#define OROFORGE_CHAIN_PEERS_HPP

#include <rtt/TaskContext.hpp>
#include <rtt/internal/engine/engine_gate.hpp>

#include <string>
#include <vector>

namespace RTT::extras {
class SlaveActivity;
}

namespace OCL::chain {

typedef boost::intrusive_ptr<const RTT::internal::EngineGate> Gate;

struct Peer {
    enum Relation { Slave, Masterless, OfOther, OwnThread, Self, Master };

    std::string name;
    Gate gate;
    RTT::extras::SlaveActivity* slave = nullptr;  // may be destroyed outside a visit to the gate
    Relation relation = OwnThread;
    std::string master;  // the component that executes it; for OfOther
};

/** Null when another thread has begun to destroy the component, which may be at any moment of a visit; what this has
    returned exists until the end of the visit. */
RTT::base::TaskCore* componentOf(const RTT::internal::EngineGate::Visit& visit);

/** The peers that are there, in alphabetical order. */
std::vector<Peer> peersOf(RTT::TaskContext& chain);

struct Order {
    std::vector<Peer> members;
    std::vector<std::string> ignored;   // peers that are no members
    std::vector<std::string> findings;  // why the order cannot be as wished
};

/** The members in the order that `wished` says: names, and "*" for all other slaves; empty for all slaves. With
    `othersFollow` there is a "*" at the end if there is none. Names that cannot be members are left out. */
Order orderOf(const std::string& chain, const std::vector<Peer>& peers, const std::vector<std::string>& wished,
              bool othersFollow);

}  // namespace OCL::chain

#endif
