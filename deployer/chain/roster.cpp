// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "roster.hpp"

#include <algorithm>

namespace OCL::chain {

std::vector<std::int64_t> RecentPeriods::all() const {
    std::vector<std::int64_t> result(std::min<std::uint64_t>(count_(), size_));
    for (std::size_t i = 0; i != result.size(); ++i) result[i] = ring_[i]();
    return result;
}

RosterExchange::~RosterExchange() {
    delete next_.load();
    destroyReplaced();
    delete current_;
}

Roster* RosterExchange::take() noexcept {
    if (next_.load(std::memory_order_relaxed) == nullptr) return current_;
    Roster* const next = next_.exchange(nullptr, std::memory_order_acq_rel);
    if (!next) return current_;
    if (Roster* const last = current_) {
        last->next = replaced_.load(std::memory_order_relaxed);
        // Only fails if the other side takes the list meanwhile, so at most once more.
        while (!replaced_.compare_exchange_weak(last->next, last, std::memory_order_release, std::memory_order_relaxed))
            continue;
    }
    current_ = next;
    return current_;
}

void RosterExchange::publish(std::unique_ptr<Roster> roster) {
    delete next_.exchange(roster.release(), std::memory_order_acq_rel);
    destroyReplaced();
}

void RosterExchange::destroyReplaced() {
    Roster* replaced = replaced_.exchange(nullptr, std::memory_order_acquire);
    while (replaced) delete std::exchange(replaced, replaced->next);
}

}  // namespace OCL::chain
