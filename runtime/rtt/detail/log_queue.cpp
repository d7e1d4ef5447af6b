// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/detail/log_queue.hpp>

#include <algorithm>
#include <cstring>

namespace RTT::detail {

LogQueue::LogQueue() : cells_(new Cell[kCells]()) { clear(); }

void LogQueue::clear() noexcept {
    for (std::uint32_t i = 0; i != kCells; ++i) cells_[i].sequence.store(i, std::memory_order_relaxed);
    tail_ = head_ = lost_ = 0;
}

std::uint32_t LogQueue::cellsOf(const LogRecord& record) noexcept {
    const std::uint32_t size = std::uint32_t(record.moduleSize) + record.textSize;
    return std::max(1u, (size + kRoom - 1) / kRoom);
}

bool LogQueue::put(const LogRecord& record, const char* module, const char* text) noexcept {
    const std::uint32_t count = cellsOf(record);
    std::uint32_t position = tail_.load(std::memory_order_relaxed);
    for (;;) {
        // Cells become free in order: if the last one is free, all are. Acquire: pairs with the release in take(); the
        // cells were read before they are overwritten.
        const std::uint32_t last = position + count - 1;
        const auto lead = static_cast<std::int32_t>(at(last).sequence.load(std::memory_order_acquire) - last);
        if (lead == 0) {
            if (tail_.compare_exchange_weak(position, position + count, std::memory_order_relaxed)) break;
        } else if (lead < 0) {
            lost_.fetch_add(1, std::memory_order_relaxed);
            return false;
        } else {
            position = tail_.load(std::memory_order_relaxed);
        }
    }
    Cell& first = at(position);
    first.record = record;
    const std::uint32_t size = std::uint32_t(record.moduleSize) + record.textSize;
    for (std::uint32_t done = 0; done != size;) {
        const bool inModule = done < record.moduleSize;
        const std::uint32_t left = inModule ? record.moduleSize - done : size - done;
        const std::uint32_t part = std::min(left, kRoom - done % kRoom);
        std::memcpy(at(position + done / kRoom).bytes + done % kRoom,
                    inModule ? module + done : text + (done - record.moduleSize), part);
        done += part;
    }
    // Release: a thread that sees this number sees the line, in all its cells.
    first.sequence.store(position + 1, std::memory_order_release);
    return true;
}

bool LogQueue::take(LogRecord& record, char* bytes) noexcept {
    // Acquire: pairs with the release in put().
    if (at(head_).sequence.load(std::memory_order_acquire) != head_ + 1) return false;
    record = at(head_).record;
    const std::uint32_t size = std::uint32_t(record.moduleSize) + record.textSize;
    for (std::uint32_t done = 0; done < size; done += kRoom)
        std::memcpy(bytes + done, at(head_ + done / kRoom).bytes, std::min(kRoom, size - done));
    const std::uint32_t end = head_ + cellsOf(record);
    // Release: producers overwrite the cells after we have read them. In order, see put().
    for (; head_ != end; ++head_) at(head_).sequence.store(head_ + kCells, std::memory_order_release);
    return true;
}

}  // namespace RTT::detail
