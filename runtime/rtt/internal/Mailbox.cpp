// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/Mailbox.hpp>

namespace RTT {
namespace internal {

Mailbox::Mailbox() : cells_(new Cell[kCapacity]) {
    for (std::size_t i = 0; i != kCapacity; ++i) cells_[i].sequence.store(i, std::memory_order_relaxed);
}

bool Mailbox::put(Item item) {
    std::size_t position = tail_.load(std::memory_order_relaxed);
    for (;;) {
        Cell& cell = cells_[position % kCapacity];
        // Acquire: pairs with the release in take(); the cell was read before it is overwritten.
        const std::size_t sequence = cell.sequence.load(std::memory_order_acquire);
        const auto lead = static_cast<std::ptrdiff_t>(sequence) - static_cast<std::ptrdiff_t>(position);
        if (lead == 0) {
            if (tail_.compare_exchange_weak(position, position + 1, std::memory_order_relaxed)) {
                cell.item = item;
                // Release: whoever sees this number sees the item.
                cell.sequence.store(position + 1, std::memory_order_release);
                return true;
            }
        } else if (lead < 0) {
            return false;  // still holds the item of the round before
        } else {
            position = tail_.load(std::memory_order_relaxed);
        }
    }
}

bool Mailbox::take(Item& item) {
    std::size_t position = head_.load(std::memory_order_relaxed);
    for (;;) {
        Cell& cell = cells_[position % kCapacity];
        // Acquire: pairs with the release in put(), so that the item is there with its number.
        const std::size_t sequence = cell.sequence.load(std::memory_order_acquire);
        const auto lead = static_cast<std::ptrdiff_t>(sequence) - static_cast<std::ptrdiff_t>(position + 1);
        if (lead == 0) {
            if (head_.compare_exchange_weak(position, position + 1, std::memory_order_relaxed)) {
                item = cell.item;
                // Release: the producer of the next round overwrites the item after we have read it.
                cell.sequence.store(position + kCapacity, std::memory_order_release);
                return true;
            }
        } else if (lead < 0) {
            return false;  // not filled yet
        } else {
            position = head_.load(std::memory_order_relaxed);
        }
    }
}

bool Mailbox::empty() const {
    const std::size_t position = head_.load(std::memory_order_acquire);
    return cells_[position % kCapacity].sequence.load(std::memory_order_acquire) != position + 1;
}

}  // namespace internal
}  // namespace RTT
