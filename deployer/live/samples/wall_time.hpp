// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_WALL_TIME_HPP
#define OROFORGE_LIVE_WALL_TIME_HPP

#include <cstdint>
#include <ctime>

namespace OCL::live {

/** Now, in ns since 1970. */
inline std::int64_t wallTime() {
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    return std::int64_t(now.tv_sec) * 1000000000 + now.tv_nsec;
}

}  // namespace OCL::live

#endif
