// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_RT_CHECK_FINDINGS_HPP
#define OROFORGE_RT_CHECK_FINDINGS_HPP

#include "interface.h"

#include <atomic>
#include <cstddef>

namespace oroforge::rt_check {

/** A call that was made, by which component and from where. */
struct Call {
    const char* component;
    oroforge_rt_place place;
    oroforge_rt_fault fault;
    const char* function;
    void* const* frames;  // the innermost first
    unsigned depth;
    const char* script;  // "file:line", or empty
};

/**
 * A place from which calls were made, with their number. Findings are in a table of fixed size: counting neither
 * allocates nor locks, even in several threads at once. Texts are made later, by threads that are not real-time.
 */
struct Finding {
    static constexpr std::size_t kLongestName = 96;
    static constexpr std::size_t kLongestScript = 160;
    static constexpr unsigned kMaxFrames = 30;

    bool isOf(const Call& call, std::size_t hash, unsigned generation) const noexcept;
    void fill(const Call& call, std::size_t hash, unsigned generation) noexcept;
    /** True for calls inside the pool of real-time memory, which holds its lock for a bounded number of
        instructions. */
    bool isAllowed() const noexcept;

    enum State : int { kFree, kBeingMade, kMade };
    std::atomic<int> state{kFree};
    std::atomic<unsigned long> count{0};
    std::size_t hash = 0;
    unsigned number = 0;      // in order of creation
    unsigned generation = 0;  // generation of the addresses in frames
    char component[kLongestName] = {};
    char script[kLongestScript] = {};
    oroforge_rt_place place = OROFORGE_RT_UPDATE;
    oroforge_rt_fault fault = OROFORGE_RT_ALLOCATION;
    const char* function = nullptr;
    unsigned depth = 0;
    void* frames[kMaxFrames] = {};
    char* texts[kMaxFrames] = {};  // null if not made yet
};

/** Counts a call, in any thread. False if there is no room. */
bool count(const Call& call) noexcept;

/** Begins a generation of addresses, because a library was unloaded and others may be loaded to its addresses. */
void beginAddressesAnew() noexcept;

/** Makes missing texts. Called by one thread at a time. */
void describeFindings();

/** Calls `visit(finding)` for all complete findings. */
template <class Visit>
void forEachFinding(Visit visit);

constexpr std::size_t kFindings = 2048;
extern Finding findings[kFindings];

template <class Visit>
void forEachFinding(Visit visit) {
    for (Finding& finding : findings)
        // Acquire: pairs with count(), which has written the other members.
        if (finding.state.load(std::memory_order_acquire) == Finding::kMade) visit(finding);
}

}  // namespace oroforge::rt_check

#endif
