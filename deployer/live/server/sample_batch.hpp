// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Samples in binary messages, for recorders.
#ifndef OROFORGE_LIVE_SAMPLE_BATCH_HPP
#define OROFORGE_LIVE_SAMPLE_BATCH_HPP

#include "../samples/port_watch.hpp"
#include "message_queue.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>

namespace OCL::live {

/**
 * Reads a port into messages of several samples (little endian):
 *
 *     u8 0x80, u32 stream, then for each sample: u32 size, u64 time (ns since 1970), u64 number, its bytes (CDR)
 *
 * Numbers count all samples of the watch, also those that are lost: what is not sent is a gap in them.
 */
class SampleBatches {
public:
    /** `channel` is that of the queue; its lower half is the number of the stream. */
    explicit SampleBatches(std::uint64_t channel) : channel_(channel) {}

    std::uint32_t stream() const { return static_cast<std::uint32_t>(channel_); }
    /** Adds what the port has to the queue, at most `most` samples. */
    void readAll(PortWatch& port, MessageQueue& queue, unsigned most);
    /** The number that the next sample will have. */
    std::uint64_t next() const { return taken_ + dropped_; }

private:
    const std::uint64_t channel_;
    std::uint64_t taken_ = 0, dropped_ = 0;
};

/** How the samples of a watch are described: `schema: {name, encoding, text}`, `units`, `fingerprint`. Throws Failure
    if their type cannot be. */
nlohmann::json schemaOf(const PortWatch& port);

}  // namespace OCL::live

#endif
