// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "record_ring.hpp"

#include <algorithm>
#include <cstring>

namespace OCL::reporting {
namespace {

std::size_t powerOfTwoFrom(std::size_t size) {
    std::size_t result = 4096;
    while (result < size) result *= 2;
    return result;
}

}  // namespace

RecordRing::RecordRing(std::size_t capacity) : mask_(powerOfTwoFrom(capacity) - 1) {
    bytes_.reset(new char[mask_ + 1]);
    std::memset(bytes_.get(), 0, mask_ + 1);
}

bool RecordRing::push(const char* record, std::size_t size) {
    const std::uint64_t at = filled_.load(std::memory_order_relaxed);  // only this thread changes it
    const std::size_t needed = sizeof(Length) + size;
    if (at + needed - seenEmptied_ > capacity()) {
        // Acquire, pairs with pop(), which has read these bytes before they are overwritten here.
        seenEmptied_ = emptied_.load(std::memory_order_acquire);
        if (at + needed - seenEmptied_ > capacity()) return false;
    }
    const Length length = static_cast<Length>(size);
    put(at, &length, sizeof length);
    put(at + sizeof length, record, size);
    // Release, pairs with pop() and empty(): a thread that sees the new number sees the bytes.
    filled_.store(at + needed, std::memory_order_release);
    return true;
}

bool RecordRing::pop(std::vector<char>& record) {
    const std::uint64_t at = emptied_.load(std::memory_order_relaxed);  // only this thread changes it
    if (empty()) return false;
    Length length = 0;
    take(at, &length, sizeof length);
    record.resize(length);
    take(at + sizeof length, record.data(), length);
    emptied_.store(at + sizeof length + length, std::memory_order_release);
    return true;
}

bool RecordRing::drop(char* begin, std::size_t size) {
    const std::uint64_t at = emptied_.load(std::memory_order_relaxed);  // only this thread changes it
    if (empty()) return false;
    Length length = 0;
    take(at, &length, sizeof length);
    take(at + sizeof length, begin, std::min<std::size_t>(size, length));
    emptied_.store(at + sizeof length + length, std::memory_order_release);
    return true;
}

bool RecordRing::empty() const {
    return filled_.load(std::memory_order_acquire) == emptied_.load(std::memory_order_relaxed);
}

void RecordRing::put(std::uint64_t at, const void* from, std::size_t size) {
    const std::size_t begin = static_cast<std::size_t>(at) & mask_;
    const std::size_t first = std::min(size, capacity() - begin);
    std::memcpy(bytes_.get() + begin, from, first);
    std::memcpy(bytes_.get(), static_cast<const char*>(from) + first, size - first);
}

void RecordRing::take(std::uint64_t at, void* to, std::size_t size) const {
    const std::size_t begin = static_cast<std::size_t>(at) & mask_;
    const std::size_t first = std::min(size, capacity() - begin);
    if (size == 0) return;
    std::memcpy(to, bytes_.get() + begin, first);
    std::memcpy(static_cast<char*>(to) + first, bytes_.get(), size - first);
}

}  // namespace OCL::reporting
