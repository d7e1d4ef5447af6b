// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/flow/channel_array.hpp>

#include <rtt/internal/flow/reclaimer.hpp>

#include <new>

namespace RTT::internal {

static_assert(sizeof(ChannelArray) % alignof(ChannelArray::Entry) == 0, "entries follow the head without a gap");

ChannelArray* ChannelArray::make(const Entry* entries, std::size_t size) {
    if (size == 0) return nullptr;
    ChannelArray* array = new (::operator new(sizeof(ChannelArray) + size * sizeof(Entry))) ChannelArray;
    array->size = size;
    Entry* to = reinterpret_cast<Entry*>(array + 1);
    for (std::size_t i = 0; i < size; ++i) {
        new (to + i) Entry{entries[i].channel, entries[i].mandatory, entries[i].channel->storageCore()};
        entries[i].channel->ref();
    }
    return array;
}

void ChannelArray::retire(const ChannelArray* array) {
    if (!array) return;
    Reclaimer::retire(const_cast<ChannelArray*>(array), [](void* object) {
        ChannelArray* dead = static_cast<ChannelArray*>(object);
        for (const Entry& entry : *dead) entry.channel->deref();
        ::operator delete(dead);
    });
}

}  // namespace RTT::internal
