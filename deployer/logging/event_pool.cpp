// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "event_pool.hpp"

#include "origin.hpp"

#include <rtt/Logger.hpp>

#include <new>

namespace OCL::logging {

EventPool& EventPool::instance() {
    static EventPool& pool = *new EventPool;
    return pool;
}

EventPool::EventPool() {
    bool full = false;
    for (Place& place : places_) {
        try {
            if (!full) place.own.reserve(kCategory, kMessage);
        } catch (const std::bad_alloc&) {
            full = true;
        }
        place.event.store(&place.own, std::memory_order_release);
    }
    if (full)
        RTT::log(RTT::Error)
            << "real-time memory is used up, so messages to categories are cut; give the deployer more "
               "by --rtalloc-mem-size"
            << RTT::endlog();
}

EventPool::Claim::Claim(EventPool& pool) noexcept {
    const std::size_t first = origin().number;
    for (std::size_t i = 0; i < kEvents; ++i) {
        std::atomic<LoggingEvent*>& place = pool.places_[(first + i) % kEvents].event;
        if (!place.load(std::memory_order_relaxed)) continue;
        event_ = place.exchange(nullptr, std::memory_order_acquire);
        if (!event_) continue;
        place_ = &place;
        return;
    }
}

}  // namespace OCL::logging
