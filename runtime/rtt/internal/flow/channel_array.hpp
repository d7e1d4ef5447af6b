// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The array of channels that writers and readers walk through.
#ifndef ORO_INTERNAL_CHANNEL_ARRAY_HPP
#define ORO_INTERNAL_CHANNEL_ARRAY_HPP

#include <rtt/base/ChannelElementBase.hpp>
#include <rtt/internal/flow/storage_core.hpp>

#include <cstddef>

namespace RTT {
namespace internal {

/** Never changes once other threads can see it: connecting and disconnecting make a new one. Holds a reference on each
    of its channels. Entries follow the head in the same block. */
struct ChannelArray {
    struct Entry {
        base::ChannelElementBase* channel;
        bool mandatory;
        /** Set by make() if the channel stores samples: ports then bypass the channel's virtual functions. */
        StorageCore* storage = nullptr;

        WriteStatus write(const void* sample) const {
            return storage ? storage->write(sample, *channel) : channel->writeErased(sample);
        }
        FlowStatus read(void* sample, bool copyOld) const {
            return storage ? storage->store().read(sample, copyOld) : channel->readErased(sample, copyOld);
        }
    };

    std::size_t size = 0;

    const Entry* begin() const { return reinterpret_cast<const Entry*>(this + 1); }
    const Entry* end() const { return begin() + size; }

    /** Null if there are no entries. */
    static ChannelArray* make(const Entry* entries, std::size_t size);
    /** Gives `array`, which may be null, to the Reclaimer. */
    static void retire(const ChannelArray* array);
};

}  // namespace internal
}  // namespace RTT

#endif
