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
 * (base::ExecutableInterface::isIdle()) cost a round nothing. Only for the engine's thread, except wake(). Real-time
 * safe, except add().
 *
 * A thread that gives an idle function something to do does that first and then increments wakes_. The engine reads the
 * count and then asks which functions are idle. So either it finds that the function has something to do, or it finds
 * another count later. All engines share one count, because the engine of the function may be destroyed meanwhile.
 */
class RTT_API FunctionList {
public:
    /** A walk over the functions that are due. Leaves out those that are added meanwhile. */
    struct Round {
        std::size_t next, end;
    };

    FunctionList();
    /** Allocates beyond 64 functions. */
    void add(base::ExecutableInterface* function);
    /** Leaves a hole, because a round may be in progress. */
    void remove(base::ExecutableInterface* function);
    /** Closes the holes. Not for use within a round. */
    void tidy();

    /** Looks for functions that are no longer idle, if there may be some. */
    void takeWoken() {
        // Acquire: pairs with the release in wake(), so that everything done before it is seen below.
        const std::size_t wakes = wakes_.load(std::memory_order_acquire);
        if (wakes != seen_) findWoken(wakes);
    }
    Round begin() const { return {0, all_.size()}; }
    /** Null at the end. */
    base::ExecutableInterface* next(Round& round) const;
    /** `function`, which next() gave last, is still in the list. */
    bool has(const Round& round, const base::ExecutableInterface* function) const {
        return all_[round.next - 1] == function;
    }
    /** Removes the function that next() gave last. */
    void drop(const Round& round);
    /** Leaves the function that next() gave last out from now on, if it is idle. */
    void rest(const Round& round);

    /** All functions, idle or not, for the end. */
    template <class Action>
    void forEach(Action action) const {
        for (base::ExecutableInterface* const function : all_)
            if (function) action(*function);
    }

    /** Makes all engines look for functions that are no longer idle. Any thread. */
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
    std::vector<Bits> due_;                        // a bit for each function
    std::size_t seen_;                             // the last count read from wakes_
    bool holes_ = false;
};

}  // namespace internal
}  // namespace RTT

#endif
