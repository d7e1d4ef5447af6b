// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Where and when a writer writes.
#ifndef ORO_INTERNAL_DETAIL_WRITER_PLACE_HPP
#define ORO_INTERNAL_DETAIL_WRITER_PLACE_HPP

#include <cstdint>

#include <sched.h>
#include <time.h>
#include <unistd.h>

namespace RTT {
namespace internal {
namespace detail {

/** The processor that executes this thread at the moment; only a hint. */
inline unsigned processorNow() {
    const int processor = ::sched_getcpu();
    return processor < 0 ? 0 : static_cast<unsigned>(processor);
}

/** Nanoseconds that no thread sees go backwards, whatever the time service of the runtime says. */
inline std::uint64_t stampNow() {
    timespec now;
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<std::uint64_t>(now.tv_sec) * 1000000000u + static_cast<std::uint64_t>(now.tv_nsec);
}

inline unsigned processorCount() {
    const long count = ::sysconf(_SC_NPROCESSORS_CONF);
    return count < 1 ? 1 : static_cast<unsigned>(count);
}

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
