// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/os/TimeService.hpp>

namespace RTT::os {

TimeService* TimeService::Instance() {
    // Constant-initialised and trivially destroyed, so that static constructors and destructors can use it.
    static TimeService instance;
    return &instance;
}

bool TimeService::Release() {
    Instance()->word_.store(pack(0, true));
    return true;
}

TimeService::ticks TimeService::getTicks() const {
    // Relaxed: the word publishes no other data.
    const ticks word = word_.load(std::memory_order_relaxed);
    return offsetOf(word) + (enabledOf(word) ? rtos_get_time_ticks() : 0);
}

TimeService::ticks TimeService::ticksChange(ticks delta) {
    word_.fetch_add(delta * 2);  // leaves the flag alone
    return getTicks();
}

TimeService::Seconds TimeService::secondsChange(Seconds delta) {
    return nsecs_to_Seconds(ticks2nsecs(ticksChange(nsecs2ticks(Seconds_to_nsecs(delta)))));
}

void TimeService::enableSystemClock(bool yes) {
    ticks word = word_.load();
    ticks changed;
    do {
        if (enabledOf(word) == yes) return;
        // The offset takes over what the clock contributed, or gives it back, so that the time does not jump.
        const ticks clock = rtos_get_time_ticks();
        changed = pack(offsetOf(word) + (yes ? -clock : clock), yes);
    } while (!word_.compare_exchange_weak(word, changed));
}

bool TimeService::systemClockEnabled() const { return enabledOf(word_.load()); }

}  // namespace RTT::os
