// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The array of channels that writers and readers walk through.
#ifndef ORO_INTERNAL_CHANNEL_ARRAY_HPP
#define ORO_INTERNAL_CHANNEL_ARRAY_HPP

#include <rtt/base/ChannelElementBase.hpp>
#include <rtt/internal/StorageCore.hpp>

#include <cstddef>

namespace RTT {
namespace internal {

/** Never changed once it can be seen by others: who connects or disconnects makes a new one. Holds a reference on each
    of its channels. Entries follow the head in the same block. */
struct ChannelArray {
    struct Entry {
        base::ChannelElementBase* channel;
        bool mandatory;
        /** Of the channel, if that stores samples: ports use it without the channel's virtual functions. Set by make(). */
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

    /** Null for no entries. */
    static ChannelArray* make(const Entry* entries, std::size_t size);
    /** Gives `array` to the Reclaimer; null is allowed. */
    static void retire(const ChannelArray* array);
};

}  // namespace internal
}  // namespace RTT

#endif
