// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Presence with threads of the checker. To be included after checker/substitute.hpp and before the runtime's sources.
#ifndef OROFORGE_MODEL_CHECKED_PRESENCE_HPP
#define OROFORGE_MODEL_CHECKED_PRESENCE_HPP

// All threads of the checker are one of the system's, which is what a key would belong to.
#define pthread_key_create(key, destructor) static_cast<void>(0)
#define pthread_setspecific(key, value) static_cast<void>(0)

namespace model {

/** See faults/small_presence.cmake. */
template <class Records>
void linkAll(Records& records) {
    for (auto& record : records.pool_) {
        record.next = records.records_.load();
        records.records_.store(&record);
    }
}

}  // namespace model

#include <rtt/internal/engine/presence.cpp>

namespace model {

/** As at the start of a program: what a run leaves behind must not reach the next one. */
inline void preparePresence(bool asymmetric = true) {
    using RTT::internal::Presence;
    typedef Presence::State State;
    threadLocal(&Presence::record_, sizeof Presence::record_);
    threadLocal(&State::current, sizeof State::current);
    new (&State::instance()) State;
    State::asymmetric = asymmetric;
    Presence::attention_ = asymmetric ? 0 : 1;
}

}  // namespace model

#endif
