// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What tools show of connections.
#ifndef ORO_INTERNAL_CONNECTION_FACTS_HPP
#define ORO_INTERNAL_CONNECTION_FACTS_HPP

#include <rtt/base/ChannelElementBase.hpp>
#include <rtt/rtt-config.h>

#include <cstdint>
#include <string>
#include <vector>

namespace RTT {
class ConnPolicy;
namespace base {
class PortInterface;
}
namespace internal {

/** "data", "buffer 10", "circular buffer 10", "unbuffered". */
RTT_API std::string policyText(const ConnPolicy& policy);

/** The first element of a channel that stores samples, from that one on towards the reader or the writer. Null if there
    is none. */
RTT_API base::ChannelElementBase::shared_ptr storageFrom(base::ChannelElementBase::shared_ptr element,
                                                         bool towardsReader);

/** For each connection of an input port, the first element before the port that stores samples. Not real-time safe. */
RTT_API std::vector<base::ChannelElementBase::shared_ptr> storagesOf(const base::PortInterface& input);

/** The number of samples that found no room in these elements, each of which stores samples. */
RTT_API std::uint64_t droppedIn(const std::vector<base::ChannelElementBase::shared_ptr>& storages);

/** The number of samples for an input port that found no room, in all its present connections. Not real-time safe. */
RTT_API std::uint64_t droppedSamples(const base::PortInterface& input);

/** Another number after each change of the connections of any port: until then, what was found of them is still true.
    Real-time safe, any thread. */
RTT_API std::uint64_t connectionChanges();
/** By the port's ConnectionManager, after each change. */
void countConnectionChange();

}  // namespace internal
}  // namespace RTT

#endif
