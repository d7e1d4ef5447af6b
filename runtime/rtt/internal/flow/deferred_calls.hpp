// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Functions that a thread calls as soon as it has left its Reclaimer::Guard.
#ifndef ORO_INTERNAL_DEFERRED_CALLS_HPP
#define ORO_INTERNAL_DEFERRED_CALLS_HPP

#include <rtt/rtt-config.h>

#include <cstdint>

namespace RTT {
namespace internal {
namespace detail {
class Waiting;
}

/** The calls of one thread, first in, first out. Only that thread touches them, except within a detail::Waiting. */
class RTT_API DeferredCalls {
public:
    /** `argument` becomes null when the call is cancelled or abandoned, even while the function runs. */
    typedef void (*Function)(void*& argument);
    struct Call {
        Function function;
        void* argument;
        Call* next;
    };
    static constexpr std::uint32_t kSpare = 16;

    bool empty() const noexcept { return first_ == nullptr; }
    /** Keeps the call in `own`, memory of the caller that is in use until the call begins, or in a spare place if that
        is null. False if no spare place is free. Real-time safe. */
    bool add(Call* own, Function function, void* argument) noexcept;
    /** Makes all calls. Those that they add are left to the next run(), which may be nested in this one. */
    void run();

    /** Cancels the calls with this argument that have not begun; returns their number. */
    unsigned cancel(const void* argument) noexcept;
    /** The number of calls with this argument in progress; above one if they are nested. */
    unsigned making(const void* argument) const noexcept;
    /** Sets the argument of the calls in progress to null; returns their number. */
    unsigned abandon(const void* argument) noexcept;

private:
    friend class detail::Waiting;
    /** The calls of one run(). Lives on the stack. */
    struct Batch {
        Call* first;
        void* argument;  // of the call in progress
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
