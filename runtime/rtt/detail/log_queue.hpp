// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_DETAIL_LOG_QUEUE_HPP
#define RTT_DETAIL_LOG_QUEUE_HPP

#include <rtt/rtt-config.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace RTT {
namespace detail {

/** A line on its way through the queue. */
struct LogRecord {
    std::int64_t time;  // ns since the reference time
    std::int64_t wall;  // ns since 1970
    std::uint32_t cut;  // number of characters that were cut off
    std::uint16_t moduleSize, textSize;
    std::uint8_t level;
    bool bare, forReceiver;  // as in LogParts
};

/**
 * Bounded first-in-first-out queue for the lines of real-time threads. Any thread puts without waiting; one at a time
 * takes (ensured by the sink's mutex). A line takes as many neighbouring cells as it needs.
 *
 * Each cell carries a sequence number that tells whose turn it is; the numbers wrap around:
 *   sequence == position          free for the producer that wins position
 *   sequence == position + 1      first cell of a line that is complete; the others of the line keep their number
 *   sequence == position + kCells free again, one round later
 *
 * A producer that is stopped between winning its cells and completing them hides later lines until it continues.
 */
class RTT_API LogQueue {
public:
    static constexpr std::uint32_t kCells = 512;
    static constexpr std::uint32_t kRoom = 216;           // bytes of text in a cell, which has 256 bytes
    static constexpr std::uint32_t kLongest = 8 * kRoom;  // bytes of module and text together

    LogQueue();
    /** Drops all lines. No other thread may use the queue meanwhile. */
    void clear() noexcept;
    /** False if there is no room, which is counted. Real-time safe. */
    bool put(const LogRecord& record, const char* module, const char* text) noexcept;
    /** False if there is no complete line. `bytes` has room for kLongest and gets the module, then the text. */
    bool take(LogRecord& record, char* bytes) noexcept;
    /** The number of lines that found no room since the last call. */
    std::uint32_t takeLost() noexcept { return lost_.exchange(0, std::memory_order_relaxed); }

private:
    struct Cell {
        std::atomic<std::uint32_t> sequence;
        LogRecord record;  // of the first cell of a line
        char bytes[kRoom];
    };
    static std::uint32_t cellsOf(const LogRecord& record) noexcept;
    Cell& at(std::uint32_t position) noexcept { return cells_[position % kCells]; }

    std::unique_ptr<Cell[]> cells_;
    alignas(64) std::atomic<std::uint32_t> tail_{0};
    std::atomic<std::uint32_t> lost_{0};
    alignas(64) std::uint32_t head_ = 0;
};

}  // namespace detail
}  // namespace RTT
#endif
