// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_INTERRUPTION_HPP
#define ORO_INTERNAL_INTERRUPTION_HPP

#include <rtt/rtt-config.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <stdexcept>

namespace RTT {
namespace internal {

/** Thrown to the script whose statement was interrupted. No script catches it, and no called C++ code sees it. */
class RTT_API Interrupted : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
    ~Interrupted() override;
};

/**
 * While one exists, other threads can interrupt its thread, such as a command of a console that may not end. This ends
 * scripts that the thread executes, and their waiting for calls of other components, but no C++ code. They nest; the
 * innermost counts. A thread without one is never interrupted. Lives on the stack.
 */
class RTT_API Interruption {
public:
    /** Without `patient` scripts do not wait for ever, because no user is there to interrupt them. */
    explicit Interruption(bool patient = true);
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    /** Any thread. */
    void ask();
    bool asked() const noexcept { return asked_.load(std::memory_order_acquire); }
    bool isPatient() const noexcept { return patient_; }

    /** Null if there is none. Real-time safe. */
    static Interruption* ofThisThread() noexcept;
    /** The same, but null unless its innermost Region is a script. */
    static const Interruption* ofScript() noexcept;

    /** While one exists, ask() calls `told`, in the thread that asks; the constructor does if ask() was called before.
        Has no effect in a thread without Interruption. */
    class RTT_API Listener {
    public:
        explicit Listener(std::function<void()> told);
        ~Listener();
        Listener(const Listener&) = delete;
        Listener& operator=(const Listener&) = delete;

    private:
        friend class Interruption;
        Interruption* const of_;
        const std::function<void()> told_;
        Listener* const outer_;
    };

    /** What the thread executes while one exists: a script, or C++ code that a script calls. Real-time safe. */
    class Region {
    public:
        enum Kind { Native, Script };
        /** Has no effect if `interruption` is null. */
        Region(Interruption* interruption, Kind kind) noexcept
            : of_(interruption), outer_(of_ ? of_->region_ : Native) {
            if (of_) of_->region_ = kind;
        }
        ~Region() {
            if (of_) of_->region_ = outer_;
        }
        Region(const Region&) = delete;
        Region& operator=(const Region&) = delete;

    private:
        Interruption* const of_;
        const Kind outer_;
    };

    /** A waiting thread reads asked() every so many nanoseconds. */
    static constexpr std::int64_t kLook = 50000000;

private:
    Interruption* const outer_;
    const bool patient_;
    std::atomic<bool> asked_{false};
    Region::Kind region_ = Region::Native;  // touched only by its own thread
    std::mutex mutex_;
    Listener* listeners_ = nullptr;  // guarded by mutex_; the innermost first
};

}  // namespace internal
}  // namespace RTT

#endif
