// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Exclusive use of a state machine, by the engine's thread in a cycle or by a thread that gives a command.
#ifndef ORO_SCRIPTING_DETAIL_MACHINE_CLAIM_HPP
#define ORO_SCRIPTING_DETAIL_MACHINE_CLAIM_HPP

#include <rtt/os/futex.hpp>

#include <atomic>
#include <cstdint>

namespace RTT::scripting::detail {

/** The Linux id of the thread that holds the machine, 0 if there is none, and a bit that is set while others may sleep
    on it. Taken with acquire and given back with release, so a thread that takes it sees what the last one did. */
typedef std::atomic<std::uint32_t> MachineOwner;

/** Holds the machine while it exists, if it converts to true. A thread may hold it several times, because programs of
    the machine may give it commands. */
class MachineClaim {
public:
    /** Never waits; real-time safe. */
    static MachineClaim now(MachineOwner& owner) { return MachineClaim(owner, 0); }
    /** Waits some microseconds, because other threads rarely hold it longer. */
    static MachineClaim soon(MachineOwner& owner) { return MachineClaim(owner, -1); }
    /** Waits at most `ns` for other threads, and executes messages of the component that this thread executes. */
    static MachineClaim within(MachineOwner& owner, std::int64_t ns) { return MachineClaim(owner, ns); }
    ~MachineClaim() {
        if (taken_ && (owner_.exchange(0, std::memory_order_release) & kAwaited)) os::detail::futexWakeAll(owner_);
    }
    MachineClaim(const MachineClaim&) = delete;
    MachineClaim& operator=(const MachineClaim&) = delete;

    explicit operator bool() const { return taken_ || nested_; }
    /** True if a caller further up the stack holds it already. */
    bool nested() const { return nested_; }

private:
    static constexpr std::uint32_t kAwaited = 0x80000000u;

    MachineClaim(MachineOwner& owner, std::int64_t patience) : owner_(owner) {
        if (!take() && patience != 0) wait(patience);
    }
    bool take() {
        const auto self = static_cast<std::uint32_t>(os::detail::currentTid());
        std::uint32_t holder = 0;
        taken_ = owner_.compare_exchange_strong(holder, self, std::memory_order_acquire, std::memory_order_relaxed);
        nested_ = !taken_ && (holder & ~kAwaited) == self;
        return taken_ || nested_;
    }
    /** Waits; a negative time means some microseconds. */
    void wait(std::int64_t patience);

    MachineOwner& owner_;
    bool taken_ = false, nested_ = false;
};

}  // namespace RTT::scripting::detail

#endif
