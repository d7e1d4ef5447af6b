// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_EXTRAS_DETAIL_POLL_WAKER_HPP
#define RTT_EXTRAS_DETAIL_POLL_WAKER_HPP

#include <atomic>
#include <cstdint>
#include <sys/eventfd.h>
#include <unistd.h>

namespace RTT {
namespace extras {
namespace detail {

/**
 * What os::detail::WakeWord is for a thread that sleeps on a futex, for one that sleeps in poll(): the signals for it, and
 * whether it sleeps, in one word. The argument why no wake-up is lost is the same, with a write to an eventfd for the
 * system call: prepare() succeeds only if there is no signal, and the post that finds the thread asleep makes the
 * descriptor readable, so that poll() returns even if it begins after that. At most one write per sleep; one that comes
 * after the thread was woken by another descriptor ends the next poll() at once, which then finds no signal.
 */
class PollWaker {
public:
    PollWaker() = default;
    ~PollWaker() {
        if (fd_ >= 0) ::close(fd_);
    }
    PollWaker(const PollWaker&) = delete;
    PollWaker& operator=(const PollWaker&) = delete;

    /** Makes the descriptor, unless there is one already; false, with errno, if the system refuses. Before any sleep. */
    bool open() noexcept {
        if (fd_ < 0) fd_ = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
        return fd_ >= 0;
    }
    int fd() const noexcept { return fd_; }

    /** Any thread; real-time safe. Release, as in WakeWord::post(). */
    void post(std::uint32_t signals) noexcept {
        // Asleep: fd_ was made before, and is closed only when the thread has ended. Acquire, to see it.
        if (word_.fetch_or(signals, std::memory_order_acq_rel) != kAsleep) return;
        const std::uint64_t one = 1;
        const ssize_t written = ::write(fd_, &one, sizeof one);
        (void)written;  // cannot be full: the thread reads it after each sleep
    }
    /** Removes the signals that nobody has taken. */
    void forget() noexcept { word_.fetch_and(kAsleep, std::memory_order_acquire); }

    /** The waiting thread: false if there is a signal and it must not sleep. */
    bool prepare() noexcept {
        std::uint32_t nothing = 0;
        // Release: fd_, for the poster.
        return word_.compare_exchange_strong(nothing, kAsleep, std::memory_order_release, std::memory_order_relaxed);
    }
    /** The waiting thread, awake: takes the signals. */
    std::uint32_t take() noexcept { return word_.exchange(0, std::memory_order_acquire) & ~kAsleep; }
    /** The waiting thread, when poll() found the descriptor readable. */
    void drain() noexcept {
        std::uint64_t count = 0;
        const ssize_t got = ::read(fd_, &count, sizeof count);
        (void)got;
    }

private:
    static constexpr std::uint32_t kAsleep = 0x80000000u;
    std::atomic<std::uint32_t> word_{0};
    int fd_ = -1;
};

}  // namespace detail
}  // namespace extras
}  // namespace RTT
#endif
