// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_DETAIL_MESSAGE_PAUSE_HPP
#define ORO_INTERNAL_DETAIL_MESSAGE_PAUSE_HPP

#include <rtt/ExecutionEngine.hpp>
#include <rtt/internal/EngineGate.hpp>
#include <rtt/os/fosi.h>

#include <boost/function.hpp>

#include <chrono>
#include <thread>

namespace RTT {
namespace internal {
namespace detail {

constexpr std::int64_t kPauseNs = 20000;

/** Sleeps for a moment, or until a notification makes over() true; executes the messages of the components that this
    thread is executing. It does not spin, because the other thread may have a lower priority. */
inline void pauseForMessages(const boost::function<bool()>& over) {
    const EngineGate* const gate = EngineGate::ofThisThread();
    if (gate && gate->engine())
        gate->engine()->waitForMessages(over, rtos_get_time_ns() + kPauseNs);
    else
        std::this_thread::sleep_for(std::chrono::nanoseconds(kPauseNs));
}

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
