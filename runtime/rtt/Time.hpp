// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TIME_HPP
#define ORO_TIME_HPP

#include <limits>

/**
 * @file
 * Units of time and their conversions. All functions are pure and real-time safe.
 */
namespace RTT {

typedef double Seconds;
typedef long secs;
typedef long msecs;
typedef long usecs;
typedef long long nsecs;

/** Durations that never end. */
constexpr Seconds InfiniteSeconds = std::numeric_limits<Seconds>::max();
constexpr nsecs InfiniteNSecs = std::numeric_limits<nsecs>::max();

/**
 * Seconds as nanoseconds, rounded to the nearest one. Clamps values that do not fit (such as InfiniteSeconds); a
 * not-a-number gives 0.
 */
constexpr nsecs Seconds_to_nsecs(Seconds s) {
    if (s != s) return 0;
    if (s >= 9.2e9) return InfiniteNSecs;
    if (s <= -9.2e9) return -InfiniteNSecs;
    return static_cast<nsecs>(s * 1e9 + (s < 0 ? -0.5 : 0.5));
}
constexpr usecs Seconds_to_usecs(Seconds s) { return static_cast<usecs>(Seconds_to_nsecs(s) / 1000); }
constexpr msecs Seconds_to_msecs(Seconds s) { return static_cast<msecs>(Seconds_to_nsecs(s) / 1000000); }

constexpr Seconds nsecs_to_Seconds(nsecs n) { return static_cast<Seconds>(n) / 1e9; }
constexpr usecs nsecs_to_usecs(nsecs n) { return static_cast<usecs>(n / 1000); }
constexpr msecs nsecs_to_msecs(nsecs n) { return static_cast<msecs>(n / 1000000); }

constexpr nsecs usecs_to_nsecs(usecs u) { return static_cast<nsecs>(u) * 1000; }
constexpr Seconds usecs_to_Seconds(usecs u) { return static_cast<Seconds>(u) / 1e6; }
constexpr nsecs msecs_to_nsecs(msecs m) { return static_cast<nsecs>(m) * 1000000; }
constexpr Seconds msecs_to_Seconds(msecs m) { return static_cast<Seconds>(m) / 1e3; }
constexpr nsecs secs_to_nsecs(secs s) { return static_cast<nsecs>(s) * 1000000000; }

}  // namespace RTT
#endif
