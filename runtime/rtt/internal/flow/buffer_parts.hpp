// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Buffers of connections that many threads write to.
#ifndef ORO_INTERNAL_BUFFER_PARTS_HPP
#define ORO_INTERNAL_BUFFER_PARTS_HPP

#include <rtt/rtt-config.h>

#include <cstddef>

namespace RTT {
namespace internal {

/** A connection of its own (PerConnection) with at least this max_threads and a lock-free BUFFER has several parts. */
constexpr int kThreadsOfParts = 16;

/** The number of parts of such a buffer: one for each processor, at most eight, none of them smaller than eight
    samples. One if there are more than 1,048,576 samples. */
RTT_API std::size_t bufferParts(std::size_t size);
/** How many samples such a buffer allocates. */
RTT_API std::size_t bufferElements(std::size_t size, std::size_t threads);

}  // namespace internal
}  // namespace RTT

#endif
