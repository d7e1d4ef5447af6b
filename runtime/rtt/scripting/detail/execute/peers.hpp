// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_PEERS_HPP
#define ORO_SCRIPTING_DETAIL_PEERS_HPP

#include <rtt/internal/engine/engine_gate.hpp>

#include <string>
#include <vector>

namespace RTT {
class TaskContext;

namespace scripting {
namespace detail {

/** The other components whose attributes and properties a piece of script accesses by address. */
class Peers {
public:
    /** Called while the script is compiled. */
    void add(const TaskContext& component);
    /** The name of a peer that was destroyed; null if there is none. Any thread; real-time safe. */
    const std::string* lost() const {
        for (const Peer& peer : peers_)
            if (peer.gate->closed()) return &peer.name;
        return nullptr;
    }

private:
    struct Peer {
        std::string name;
        boost::intrusive_ptr<const internal::EngineGate> gate;
    };
    std::vector<Peer> peers_;
};

}  // namespace detail
}  // namespace scripting
}  // namespace RTT

#endif
