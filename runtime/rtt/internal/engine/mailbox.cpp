// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/engine/mailbox.hpp>

namespace RTT::internal {

namespace {
constexpr std::uintptr_t kKindBits = 3;
Mailbox::Kind kindOf(std::uintptr_t packed) { return static_cast<Mailbox::Kind>(packed & kKindBits); }
}  // namespace

Mailbox::Mailbox() : cells_(new Cell[kCapacity]) {
    for (std::uint32_t i = 0; i != kCapacity; ++i) {
        cells_[i].sequence.store(i, std::memory_order_relaxed);
        cells_[i].item.store(0, std::memory_order_relaxed);
    }
}

std::uintptr_t Mailbox::pack(Item item) {
    return reinterpret_cast<std::uintptr_t>(item.what) | static_cast<std::uintptr_t>(item.kind);
}

Mailbox::Item Mailbox::unpack(std::uintptr_t packed) {
    return {kindOf(packed), reinterpret_cast<void*>(packed & ~kKindBits)};
}

bool Mailbox::put(Item item) {
    std::uint32_t position = tail_.load(std::memory_order_relaxed);
    for (;;) {
        Cell& cell = cells_[position % kCapacity];
        // Acquire: pairs with the release in take(); the cell was read before it is overwritten.
        const std::uint32_t sequence = cell.sequence.load(std::memory_order_acquire);
        const auto lead = static_cast<std::int32_t>(sequence - position);
        if (lead == 0) {
            if (tail_.compare_exchange_weak(position, position + 1, std::memory_order_relaxed)) {
                cell.item.store(pack(item), std::memory_order_relaxed);
                // Release: a thread that sees this number sees the item.
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
    std::uint32_t position = head_.load(std::memory_order_relaxed);
    for (;;) {
        Cell& cell = cells_[position % kCapacity];
        // Acquire: pairs with the release in put(), so that the item is there with its number.
        const std::uint32_t sequence = cell.sequence.load(std::memory_order_acquire);
        const auto lead = static_cast<std::int32_t>(sequence - (position + 1));
        if (lead == 0) {
            if (head_.compare_exchange_weak(position, position + 1, std::memory_order_relaxed)) {
                std::uintptr_t packed = cell.item.load(std::memory_order_relaxed);
                // Either this thread or withdraw() gets the item.
                if (kindOf(packed) >= Kind::AddFunction) packed = cell.item.exchange(packed & kKindBits);
                item = unpack(packed);
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

bool Mailbox::withdraw(Item item) {
    // take() clears the cell, so an item that is found still waits.
    for (std::uint32_t i = 0; i != kCapacity; ++i) {
        std::uintptr_t packed = pack(item);
        if (cells_[i].item.compare_exchange_strong(packed, packed & kKindBits)) return true;
    }
    return false;
}

bool Mailbox::empty() const {
    const std::uint32_t position = head_.load(std::memory_order_acquire);
    return cells_[position % kCapacity].sequence.load(std::memory_order_acquire) != position + 1;
}

bool Mailbox::peek(Item& item) const {
    const std::uint32_t position = head_.load(std::memory_order_acquire);
    const Cell& cell = cells_[position % kCapacity];
    if (cell.sequence.load(std::memory_order_acquire) != position + 1) return false;
    item = unpack(cell.item.load(std::memory_order_relaxed));
    return true;
}

}  // namespace RTT::internal
