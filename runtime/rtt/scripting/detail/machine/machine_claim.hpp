// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Which thread has a state machine: the engine's in a cycle, or one that gives a command.
#ifndef ORO_SCRIPTING_DETAIL_MACHINE_CLAIM_HPP
#define ORO_SCRIPTING_DETAIL_MACHINE_CLAIM_HPP

#include <pthread.h>

#include <atomic>
#include <cstdint>

namespace RTT::scripting::detail {

/** The thread that has it; null if none. Taken with acquire, given back with release: who takes it sees what the last one did. */
typedef std::atomic<std::uintptr_t> MachineOwner;

/** Has the machine, if it converts to true, as long as it lives. The same thread may have it several times, which happens when
    a program of the machine gives it a command. */
class MachineClaim {
public:
    /** Never waits; real-time safe. */
    static MachineClaim now(MachineOwner& owner) { return MachineClaim(owner, 0); }
    /** Waits for some microseconds: other threads rarely have it for longer. */
    static MachineClaim soon(MachineOwner& owner) { return MachineClaim(owner, -1); }
    /** Waits for other threads, at most so long, and executes messages of the component that this thread is executing. */
    static MachineClaim within(MachineOwner& owner, std::int64_t ns) { return MachineClaim(owner, ns); }
    ~MachineClaim() {
        if (taken_) owner_.store(0, std::memory_order_release);
    }
    MachineClaim(const MachineClaim&) = delete;
    MachineClaim& operator=(const MachineClaim&) = delete;

    explicit operator bool() const { return taken_ || nested_; }
    /** This thread has it already, further up the stack. */
    bool nested() const { return nested_; }

private:
    MachineClaim(MachineOwner& owner, std::int64_t patience) : owner_(owner) {
        if (!take() && patience != 0) wait(patience);
    }
    bool take() {
        const std::uintptr_t self = static_cast<std::uintptr_t>(pthread_self());
        std::uintptr_t holder = 0;
        taken_ = owner_.compare_exchange_strong(holder, self, std::memory_order_acquire, std::memory_order_relaxed);
        nested_ = !taken_ && holder == self;
        return taken_ || nested_;
    }
    /** Negative: some microseconds. */
    void wait(std::int64_t patience);

    MachineOwner& owner_;
    bool taken_ = false, nested_ = false;
};

}  // namespace RTT::scripting::detail

#endif
