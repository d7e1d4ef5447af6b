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

/** Thrown to the script whose statement was interrupted. No script catches it, and C++ code that is called does not see it. */
class RTT_API Interrupted : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
    ~Interrupted() override;
};

/**
 * While one lives, other threads can interrupt what its thread does: the command of a console, which may not end. Scripts that the
 * thread executes, and calls of other components that they wait for, are ended; C++ code is not. They nest, the innermost counts.
 * In a thread that has none nothing is interrupted. Lives on the stack.
 */
class RTT_API Interruption {
public:
    /** Where nobody is there who could interrupt it, scripts are not to wait for ever: not `patient`. */
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
    /** The same; null unless its innermost Region is a script. */
    static const Interruption* ofScript() noexcept;

    /** While one lives, `told` is called by ask(), in the thread of that, and at once if that was before. Does nothing in a thread
        without Interruption. */
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

    /** What the thread executes while one lives: a script, or C++ code that is called by one. Real-time safe. */
    class Region {
    public:
        enum Kind { Native, Script };
        /** Nothing is done if that is null. */
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

    /** Who waits looks at asked() so often, in nanoseconds. */
    static constexpr std::int64_t kLook = 50000000;

private:
    Interruption* const outer_;
    const bool patient_;
    std::atomic<bool> asked_{false};
    Region::Kind region_ = Region::Native;  // of its own thread
    std::mutex mutex_;
    Listener* listeners_ = nullptr;  // guarded by mutex_; the innermost first
};

}  // namespace internal
}  // namespace RTT

#endif
