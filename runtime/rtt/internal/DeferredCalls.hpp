// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a thread calls as soon as it has left its Reclaimer::Guard.
#ifndef ORO_INTERNAL_DEFERRED_CALLS_HPP
#define ORO_INTERNAL_DEFERRED_CALLS_HPP

#include <rtt/rtt-config.h>

#include <cstdint>

namespace RTT {
namespace internal {
namespace detail {
class Waiting;
}

/** The calls of one thread, first in, first out. Touched by that thread only, except while it is in a detail::Waiting. */
class RTT_API DeferredCalls {
public:
    /** `argument` becomes null when the call has been given up, also while it is being made. */
    typedef void (*Function)(void*& argument);
    struct Call {
        Function function;
        void* argument;
        Call* next;
    };
    static constexpr std::uint32_t kSpare = 16;

    bool empty() const noexcept { return first_ == nullptr; }
    /** Keeps the call in `own`, which belongs to the caller until the call begins, or, if that is null, in a spare one.
        False if there is none. Real-time safe. */
    bool add(Call* own, Function function, void* argument) noexcept;
    /** Makes all calls. What they add is for somebody else: for the next run(), which may come within this one. */
    void run();

    /** Gives up the calls with this argument that have not begun; returns their number. */
    unsigned cancel(const void* argument) noexcept;
    /** How many calls with this argument are being made: more than one if they are made within each other. */
    unsigned making(const void* argument) const noexcept;
    /** Those get a null argument; returns their number. */
    unsigned abandon(const void* argument) noexcept;

private:
    friend class detail::Waiting;
    /** The calls of one run(). Lives on the stack. */
    struct Batch {
        Call* first;
        void* argument;  // of the call that is being made
        Batch* outer;
    };
    bool isSpare(const Call* call) const noexcept { return call >= spare_ && call < spare_ + kSpare; }
    void prepend(Call* first) noexcept;
    unsigned cancel(Batch* batch, const void* argument) noexcept;
    static unsigned abandon(Batch* batch, const void* argument) noexcept;

    Call* first_ = nullptr;
    Call* last_ = nullptr;
    Batch* batches_ = nullptr;  // innermost first
    std::uint32_t spareUsed_ = 0;
    Call spare_[kSpare];
};

}  // namespace internal
}  // namespace RTT

#endif
