// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The Reclaimer with threads of the checker. To be included after checker/substitute.hpp and before the runtime's sources.
#ifndef OROFORGE_MODEL_CHECKED_RECLAIMER_HPP
#define OROFORGE_MODEL_CHECKED_RECLAIMER_HPP

// All threads of the checker are one of the system's, which is what a key would belong to.
#define pthread_key_create(key, destructor) static_cast<void>(0)
#define pthread_setspecific(key, value) static_cast<void>(0)
#include <rtt/internal/flow/deferred_calls.cpp>
#include <rtt/internal/flow/reclaimer.cpp>

namespace model {

/** As at the start of a program: what a run leaves behind must not reach the next one. */
inline void prepareReclaimer(bool asymmetric = true) {
    using namespace RTT::internal;
    threadLocal(&Reclaimer::record_, sizeof Reclaimer::record_);
    threadLocal(&ReclaimerState::own, sizeof ReclaimerState::own);
    new (&ReclaimerState::instance()) ReclaimerState;
    ReclaimerState::asymmetric = asymmetric;
}

}  // namespace model

#endif
