// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The list of threads that wait for callbacks, and the Reclaimer whose calls they put aside. To be included after
// checker/substitute.hpp and before the runtime's sources.
#ifndef OROFORGE_MODEL_CHECKED_WAITING_HPP
#define OROFORGE_MODEL_CHECKED_WAITING_HPP

#define pthread_self() static_cast<pthread_t>(model::self() + 1)
#include <model/checked_reclaimer.hpp>
#include <rtt/internal/flow/detail/waiting.cpp>

namespace model {

typedef RTT::internal::detail::Waiting Waiting;
// Made now: their memory must not be that of a run.
const bool listsExist = (Waiting::mutex(), Waiting::all(), true);

/** As at the start of a program. */
inline void prepareWaiting() {
    prepareReclaimer();
    new (&Waiting::mutex()) std::mutex;
    new (&Waiting::all()) std::vector<Waiting*>;
    new (&Waiting::number_) std::atomic<std::uint32_t>(0);
    new (&Waiting::changes_) std::atomic<std::uint32_t>(0);
}

}  // namespace model

#endif
