// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_DETAIL_LOG_CLOCK_HPP
#define RTT_DETAIL_LOG_CLOCK_HPP

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace RTT {
namespace detail {

/** ns since 1970, UTC. Real-time safe. */
std::int64_t wallNow() noexcept;

/** The offset of the local time, looked up when it may have changed: time zones do so at whole quarters of an hour. */
class UtcOffset {
public:
    /** In seconds, for this moment. May lock and allocate. */
    int at(std::int64_t wall) noexcept;
    /** The latest result of at(). May be called by a signal handler. */
    int last() const noexcept { return offset_.load(std::memory_order_relaxed); }

private:
    std::int64_t quarter_ = INT64_MIN;
    std::atomic<int> offset_{0};
};

/** `2026-03-29T14:37:49.123+02:00` into `out`; returns its end. Neither allocates nor locks. */
constexpr std::size_t kLongestWallTime = 30;
char* formatWallTime(char* out, std::int64_t wall, int offset) noexcept;

}  // namespace detail
}  // namespace RTT
#endif
