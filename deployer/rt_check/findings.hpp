// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_RT_CHECK_FINDINGS_HPP
#define OROFORGE_RT_CHECK_FINDINGS_HPP

#include "interface.h"

#include <atomic>
#include <cstddef>

namespace oroforge::rt_check {

/** A call that was made: what, by whom, from where. */
struct Call {
    const char* component;
    oroforge_rt_place place;
    oroforge_rt_fault fault;
    const char* function;
    void* const* frames;  // the innermost first
    unsigned depth;
};

/**
 * One for each place that calls were made from, with their number. A table of fixed size: counting neither allocates nor
 * locks, also where several threads do it at once. Its texts are made later, by threads that may take their time.
 */
struct Finding {
    static constexpr std::size_t kLongestName = 96;
    static constexpr unsigned kMaxFrames = 30;

    bool isOf(const Call& call, std::size_t hash, unsigned generation) const noexcept;
    void fill(const Call& call, std::size_t hash, unsigned generation) noexcept;
    /** What is done to the pool of real-time memory is no fault: its lock is held for a bounded number of instructions. */
    bool isAllowed() const noexcept;

    enum State : int { kFree, kBeingMade, kMade };
    std::atomic<int> state{kFree};
    std::atomic<unsigned long> count{0};
    std::size_t hash = 0;
    unsigned number = 0;      // in the order in which they were made
    unsigned generation = 0;  // of the addresses in frames
    char component[kLongestName] = {};
    oroforge_rt_place place = OROFORGE_RT_UPDATE;
    oroforge_rt_fault fault = OROFORGE_RT_ALLOCATION;
    const char* function = nullptr;
    unsigned depth = 0;
    void* frames[kMaxFrames] = {};
    char* texts[kMaxFrames] = {};  // null: not known yet
};

/** Any thread. False if there is no room. */
bool count(const Call& call) noexcept;

/** A library has left the process: something else may come to the addresses that calls were made from. */
void beginAddressesAnew() noexcept;

/** For one thread at a time: makes the texts that are not made yet. */
void describeFindings();

/** Calls `visit(finding)` for all that are complete. */
template <class Visit>
void forEachFinding(Visit visit);

constexpr std::size_t kFindings = 2048;
extern Finding findings[kFindings];

template <class Visit>
void forEachFinding(Visit visit) {
    for (Finding& finding : findings)
        // Acquire: pairs with count(); what describes the call is there.
        if (finding.state.load(std::memory_order_acquire) == Finding::kMade) visit(finding);
}

}  // namespace oroforge::rt_check

#endif
