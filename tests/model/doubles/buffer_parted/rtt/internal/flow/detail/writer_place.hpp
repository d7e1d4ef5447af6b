// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A clock that each look moves on by one, and writers that change their processor each time.
#ifndef OROFORGE_MODEL_WRITER_PLACE_HPP
#define OROFORGE_MODEL_WRITER_PLACE_HPP

#include <atomic>
#include <cstdint>

namespace RTT {
namespace internal {
namespace detail {

struct WriterPlaces {
    std::atomic<std::uint64_t> clock{1};
    std::atomic<unsigned> processor{0};
};
inline WriterPlaces* writerPlaces = nullptr;

// A relaxed counter: as a clock, it is never behind what happened before, and makes nothing visible.
inline std::uint64_t stampNow() { return writerPlaces->clock.fetch_add(1, std::memory_order_relaxed); }
inline unsigned processorNow() { return writerPlaces->processor.fetch_add(1, std::memory_order_relaxed); }
inline unsigned processorCount() { return 2; }

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
