// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_RECORDING_STATE_CHANNEL_HPP
#define OROFORGE_RECORDING_STATE_CHANNEL_HPP

#include "chunk_pipe.hpp"

#include <reporting/mcap/records.hpp>
#include <rtt/TaskContext.hpp>

#include <atomic>
#include <cstdint>
#include <vector>

namespace OCL::recording {

/** A channel with the states of components, whenever they change. Used by one thread at a time, but for lost(). The
    components may be destroyed at any time. */
class StateChannel {
public:
    /** @param onlyHere looks at them only if one of this process has changed its state; components of other processes
        do not tell. */
    StateChannel(const RTT::TaskContext::PeerGates& components, bool onlyHere);

    static oroforge::mcap::Schema schema(std::uint16_t id);
    oroforge::mcap::Channel channel(std::uint16_t id, std::uint16_t schema);

    /** Adds the states that are not what they were. Allocates if there are any. */
    void add(ChunkPipe& pipe, std::uint64_t now);
    std::uint64_t lost() const { return lost_.load(std::memory_order_relaxed); }

private:
    struct Component {
        std::string name;
        boost::intrusive_ptr<const RTT::internal::EngineGate> gate;
        const char* state = nullptr;
    };
    std::vector<Component> components_;
    const bool onlyHere_;
    std::uint64_t changes_ = ~std::uint64_t(0);  // those that were seen
    std::uint16_t id_ = 0;
    std::uint32_t sequence_ = 0;
    std::atomic<std::uint64_t> lost_{0};
};

}  // namespace OCL::recording

#endif
