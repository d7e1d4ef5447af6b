// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Catches what a real-time thread must not do: allocate, free, take a lock, wait.
#ifndef OROFORGE_TESTS_SUPPORT_REAL_TIME_TRAP_HPP
#define OROFORGE_TESTS_SUPPORT_REAL_TIME_TRAP_HPP

#include <cstddef>
#include <string>

namespace oroforge::test {

/// While one lives, every call of this thread to malloc and its siblings (so new and delete), pthread locks,
/// condition variables, semaphores, sleeping functions and the futex system call that waits is recorded with
/// the stack it came from; the destructor fails the test for them. Other threads are not watched: put another trap there.
/// Does not see locks and waits inside libc itself, such as those of stdio.
///
///     RealTimeTrap trap;
///     port.write(sample);
///
/// The program links oroforge_real_time_trap, which puts its own functions in front of libc's. Sanitizers do the
/// same, so there it sees nothing: begin tests with OROFORGE_NEEDS_REAL_TIME_TRAP().
class RealTimeTrap {
public:
    enum Kind : unsigned { kAllocation = 1, kRelease = 2, kLock = 4, kWait = 8, kEverything = 15 };

    explicit RealTimeTrap(unsigned kinds = kEverything, const char* file = __builtin_FILE(),
                          int line = __builtin_LINE());
    ~RealTimeTrap();
    RealTimeTrap(const RealTimeTrap&) = delete;
    RealTimeTrap& operator=(const RealTimeTrap&) = delete;

    /// Ends the watch before the destructor does.
    void stop() noexcept;
    /// How many calls of these kinds it has seen. Stop it before.
    unsigned caught(unsigned kinds = kEverything) const noexcept;
    /// The calls with their stacks, as the failure shows them. Stop it before.
    std::string report() const;
    /// The destructor does not fail the test.
    void forgive() noexcept { forgiven_ = true; }

    /// False under AddressSanitizer and ThreadSanitizer.
    static bool works() noexcept;

    /// Used by the functions in front of libc's.
    void note(Kind kind, const char* function, const void* caller) noexcept;

private:
    static constexpr int kMaxCalls = 16;  // as many are shown; all are counted
    static constexpr int kMaxFrames = 24;
    struct Call {
        const char* function;
        const void* caller;
        void* frames[kMaxFrames];
        int depth;
    };
    const char* const file_;
    const int line_;
    const unsigned kinds_;
    bool forgiven_ = false;
    bool noting_ = false;
    unsigned counts_[4] = {};
    int calls_ = 0;
    Call shown_[kMaxCalls];
};

/// Fails the test for what f() does that a real-time thread must not do.
template <class F>
void expectRealTime(F&& f, unsigned kinds = RealTimeTrap::kEverything, const char* file = __builtin_FILE(),
                    int line = __builtin_LINE()) {
    RealTimeTrap trap(kinds, file, line);
    f();
}

}  // namespace oroforge::test

#define OROFORGE_NEEDS_REAL_TIME_TRAP()         \
    if (!oroforge::test::RealTimeTrap::works()) \
    GTEST_SKIP() << "a sanitizer stands in front of malloc() and the locks already"

#endif
