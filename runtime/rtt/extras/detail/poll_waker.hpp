// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_EXTRAS_DETAIL_POLL_WAKER_HPP
#define RTT_EXTRAS_DETAIL_POLL_WAKER_HPP

#include <rtt/os/descriptor.hpp>

#include <atomic>
#include <cstdint>
#include <sys/eventfd.h>
#include <unistd.h>

namespace RTT {
namespace extras {
namespace detail {

/**
 * Like os::detail::WakeWord, but for a thread that sleeps in poll(): one word with the signals for it and the flag that
 * it sleeps. No wake-up is lost for the same reason, with a write to an eventfd as the system call: prepare() succeeds
 * only if there is no signal, and the post that finds the thread asleep makes the descriptor readable, so that poll()
 * returns even if it begins later. There is at most one write per sleep. A write after another descriptor woke the
 * thread ends the next poll() at once, which then finds no signal.
 */
class PollWaker {
public:
    PollWaker() = default;
    PollWaker(const PollWaker&) = delete;
    PollWaker& operator=(const PollWaker&) = delete;

    /** Creates the descriptor if there is none; false, with errno, if the system refuses. Must be called before any
        sleep. */
    bool open() noexcept {
        if (!fd_) fd_.reset(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
        return static_cast<bool>(fd_);
    }
    int fd() const noexcept { return fd_.get(); }

    /** Any thread; real-time safe. Release, as in WakeWord::post(). */
    void post(std::uint32_t signals) noexcept {
        // If the thread is asleep, fd_ exists; it is closed only after the thread has ended. Acquire, to see it.
        if (word_.fetch_or(signals, std::memory_order_acq_rel) != kAsleep) return;
        const std::uint64_t one = 1;
        const ssize_t written = ::write(fd_.get(), &one, sizeof one);
        (void)written;  // cannot be full: the thread reads it after each sleep
    }
    /** Removes signals that were not taken. */
    void forget() noexcept { word_.fetch_and(kAsleep, std::memory_order_acquire); }

    /** Called by the waiting thread: false if there is a signal and it must not sleep. */
    bool prepare() noexcept {
        std::uint32_t nothing = 0;
        // Release: fd_, for the poster.
        return word_.compare_exchange_strong(nothing, kAsleep, std::memory_order_release, std::memory_order_relaxed);
    }
    /** Called by the waiting thread when it is awake: takes the signals. */
    std::uint32_t take() noexcept { return word_.exchange(0, std::memory_order_acquire) & ~kAsleep; }
    /** Called by the waiting thread when poll() found the descriptor readable. */
    void drain() noexcept {
        std::uint64_t count = 0;
        const ssize_t got = ::read(fd_.get(), &count, sizeof count);
        (void)got;
    }

private:
    static constexpr std::uint32_t kAsleep = 0x80000000u;
    std::atomic<std::uint32_t> word_{0};
    os::detail::Descriptor fd_;
};

}  // namespace detail
}  // namespace extras
}  // namespace RTT
#endif
