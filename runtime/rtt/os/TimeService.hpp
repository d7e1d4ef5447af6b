// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_TIME_SERVICE_HPP
#define ORO_OS_TIME_SERVICE_HPP

#include <rtt/Time.hpp>
#include <rtt/os/fosi.h>

#include <atomic>
#include <limits>

namespace RTT {
namespace os {

/**
 * The time of the process: CLOCK_MONOTONIC plus an offset, or simulated time, which is the offset alone. Every function
 * is lock-free, real-time safe and may be called from any thread.
 */
class RTT_API TimeService {
public:
    typedef long long ticks;
    typedef RTT::nsecs nsecs;
    typedef RTT::Seconds Seconds;

    static constexpr ticks InfiniteTicks = std::numeric_limits<ticks>::max();
    static constexpr nsecs InfiniteNSecs = RTT::InfiniteNSecs;
    static constexpr Seconds InfiniteSeconds = RTT::InfiniteSeconds;

    static TimeService* Instance();
    /** Returns to the system clock without an offset. The instance stays valid. */
    static bool Release();

    static ticks nsecs2ticks(nsecs n) { return nano2ticks(n); }
    static nsecs ticks2nsecs(ticks t) { return ticks2nano(t); }

    /** The time since an unspecified, fixed moment. */
    ticks getTicks() const;
    nsecs getNSecs() const { return ticks2nsecs(getTicks()); }
    Seconds getSeconds() const { return nsecs_to_Seconds(getNSecs()); }
    ticks ticksGet() const { return getTicks(); }
    Seconds secondsGet() const { return getSeconds(); }

    /** The time since `since`, a value of getTicks(), getNSecs() or getSeconds(). */
    ticks getTicks(const ticks& since) const { return getTicks() - since; }
    nsecs getNSecs(const nsecs& since) const { return getNSecs() - since; }
    Seconds getSeconds(const Seconds& since) const { return getSeconds() - since; }
    /** The same for a variable, but if it is 0, sets it to the present time and returns that. */
    ticks getTicks(ticks& since) const { return since == 0 ? since = getTicks() : getTicks() - since; }
    nsecs getNSecs(nsecs& since) const { return since == 0 ? since = getNSecs() : getNSecs() - since; }
    Seconds getSeconds(Seconds& since) const { return since == 0 ? since = getSeconds() : getSeconds() - since; }
    ticks ticksSince(ticks since) const { return getTicks(since); }
    /** The seconds since the tick value `since`. */
    Seconds secondsSince(ticks since) const { return nsecs_to_Seconds(ticks2nsecs(getTicks(since))); }

    /** Moves the time by delta and returns the new time. */
    ticks ticksChange(ticks delta);
    Seconds secondsChange(Seconds delta);

    /** Without the system clock, only the two functions above move the time. */
    void enableSystemClock(bool yes);
    bool systemClockEnabled() const;

private:
    TimeService() = default;
    // Offset and "clock enabled" share a word, so that a reader always sees both of the same change.
    static constexpr ticks pack(ticks offset, bool enabled) { return offset * 2 + (enabled ? 1 : 0); }
    static constexpr ticks offsetOf(ticks word) { return word >> 1; }
    static constexpr bool enabledOf(ticks word) { return (word & 1) != 0; }

    std::atomic<ticks> word_{pack(0, true)};
};

}  // namespace os
}  // namespace RTT

namespace RTT {
using os::TimeService;
}
#endif
