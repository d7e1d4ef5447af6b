// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/engine/function_list.hpp>

#include <rtt/base/ExecutableInterface.hpp>

#include <algorithm>

namespace RTT {

void base::ExecutableInterface::wake() const noexcept { internal::FunctionList::wake(); }

namespace internal {

std::atomic<std::size_t> FunctionList::wakes_{0};

FunctionList::FunctionList() : seen_(wakes_.load(std::memory_order_acquire)) {
    all_.reserve(kBits);
    due_.reserve(1);
}

void FunctionList::setDue(std::size_t index, bool due) {
    Bits& bits = due_[index / kBits];
    bits = due ? bits | bit(index) : bits & ~bit(index);
}

void FunctionList::add(base::ExecutableInterface* function) {
    if (all_.size() % kBits == 0) due_.push_back(0);
    all_.push_back(function);
    setDue(all_.size() - 1, true);
}

void FunctionList::remove(base::ExecutableInterface* function) {
    for (std::size_t i = 0; i != all_.size(); ++i) {
        if (all_[i] != function) continue;
        all_[i] = nullptr;
        setDue(i, false);
        holes_ = true;
    }
}

void FunctionList::tidy() {
    if (!holes_) return;
    holes_ = false;
    std::size_t kept = 0;
    for (std::size_t i = 0; i != all_.size(); ++i) {
        if (!all_[i]) continue;
        const bool due = isDue(i);
        all_[kept] = all_[i];
        setDue(kept++, due);
    }
    all_.resize(kept);
    due_.resize((kept + kBits - 1) / kBits);
    // Clear the bits beyond the last function.
    if (kept % kBits != 0) due_.back() &= bit(kept) - 1;
}

void FunctionList::findWoken(std::size_t wakes) {
    seen_ = wakes;
    for (std::size_t i = 0; i != all_.size(); ++i)
        if (all_[i] && !isDue(i) && !all_[i]->isIdle()) setDue(i, true);
}

base::ExecutableInterface* FunctionList::next(Round& round) const {
    while (round.next < round.end) {
        const Bits later = due_[round.next / kBits] & ~(bit(round.next) - 1);
        if (later == 0) {
            round.next += kBits - round.next % kBits;
            continue;
        }
        const std::size_t index = round.next - round.next % kBits + static_cast<std::size_t>(__builtin_ctzll(later));
        if (index >= round.end) break;
        round.next = index + 1;
        if (all_[index]) return all_[index];
    }
    return nullptr;
}

void FunctionList::drop(const Round& round) {
    all_[round.next - 1] = nullptr;
    setDue(round.next - 1, false);
    holes_ = true;
}

void FunctionList::rest(const Round& round) {
    if (all_[round.next - 1]->isIdle()) setDue(round.next - 1, false);
}

}  // namespace internal
}  // namespace RTT
