// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_FUNCTION_LIST_HPP
#define ORO_INTERNAL_FUNCTION_LIST_HPP

#include <rtt/rtt-config.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace RTT {
namespace base {
class ExecutableInterface;
}
namespace internal {

/**
 * The functions of an ExecutionEngine, in the order in which they were added. Those that are idle
 * (base::ExecutableInterface::isIdle()) cost a round nothing. Belongs to the engine's thread, but for wake(). Real-time safe,
 * apart from add().
 *
 * Whoever gives an idle function something to do does that first and counts wakes_ up then. The engine reads the count, then
 * asks who is idle. So either it finds out that the function has something to do, or it finds another count later. There is
 * one count for all engines: who wakes a function would else have to know that the engine of that is not destroyed meanwhile.
 */
class RTT_API FunctionList {
public:
    /** A walk over those that are due. Functions that are added meanwhile are not part of it. */
    struct Round {
        std::size_t next, end;
    };

    FunctionList();
    /** Allocates beyond 64 of them. */
    void add(base::ExecutableInterface* function);
    /** Leaves a hole, because a round may be under way. */
    void remove(base::ExecutableInterface* function);
    /** Closes the holes. Not within a round. */
    void tidy();

    /** Looks for those that were idle and are no more, if there may be some. */
    void takeWoken() {
        // Acquire: pairs with the release in wake(), so that what was done before is seen below.
        const std::size_t wakes = wakes_.load(std::memory_order_acquire);
        if (wakes != seen_) findWoken(wakes);
    }
    Round begin() const { return {0, all_.size()}; }
    /** Null at the end. */
    base::ExecutableInterface* next(Round& round) const;
    /** `function`, which next() gave last, is still among them. */
    bool has(const Round& round, const base::ExecutableInterface* function) const {
        return all_[round.next - 1] == function;
    }
    /** Removes what next() gave last. */
    void drop(const Round& round);
    /** Leaves what next() gave last out from now on, if it is idle. */
    void rest(const Round& round);

    /** All of them, idle or not, for the end. */
    template <class Action>
    void forEach(Action action) const {
        for (base::ExecutableInterface* const function : all_)
            if (function) action(*function);
    }

    /** Has all engines look for functions that are not idle any more. Any thread. */
    static void wake() noexcept { wakes_.fetch_add(1, std::memory_order_release); }

private:
    static constexpr std::size_t kBits = 64;
    typedef std::uint64_t Bits;
    static Bits bit(std::size_t index) { return Bits(1) << index % kBits; }
    bool isDue(std::size_t index) const { return due_[index / kBits] & bit(index); }
    void setDue(std::size_t index, bool due);
    void findWoken(std::size_t wakes);

    static std::atomic<std::size_t> wakes_;

    std::vector<base::ExecutableInterface*> all_;  // null: a hole
    std::vector<Bits> due_;                        // a bit for each of them
    std::size_t seen_;                             // of wakes_
    bool holes_ = false;
};

}  // namespace internal
}  // namespace RTT

#endif
