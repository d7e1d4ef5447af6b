// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_FAILURE_REPORT_HPP
#define ORO_INTERNAL_FAILURE_REPORT_HPP

#include <rtt/rtt-config.h>

#include <string>
#include <utility>

namespace RTT {
class Service;

namespace internal {

/**
 * Why an operation returns false, for a script that called it and does not look at what it returned: the script knows the file
 * and the line, the operation the reason. While one lives, it collects what operations give in its thread. They nest, and live
 * on the stack.
 */
class RTT_API FailureReport {
public:
    FailureReport() noexcept;
    ~FailureReport();
    FailureReport(const FailureReport&) = delete;
    FailureReport& operator=(const FailureReport&) = delete;

    /** All reasons, separated by semicolons; empty: none was given. */
    const std::string& reasons() const noexcept { return reasons_; }
    /** For operations, which return false then. False if nobody collects: then the log has to have it. Allocates. */
    static bool give(const std::string& reason);
    /** True if somebody in this thread collects. */
    static bool isWanted() noexcept;

    /** While one lives, nothing is collected in its thread: what is executed there is code of others. On the stack. */
    class RTT_API Pause {
    public:
        Pause() noexcept;
        ~Pause();
        Pause(const Pause&) = delete;
        Pause& operator=(const Pause&) = delete;

    private:
        FailureReport* const paused_;
    };

    /** While one lives, the next call of the queue that this thread executes gives its reasons to that report. On the stack. */
    class RTT_API OfSent {
    public:
        explicit OfSent(FailureReport& report) noexcept;
        ~OfSent();
        OfSent(const OfSent&) = delete;
        OfSent& operator=(const OfSent&) = delete;
    };

    /** Services whose operations give reasons. Any thread; these wait for each other. */
    static void add(const Service& service);
    static void remove(const Service& service);
    static bool comesFrom(const Service& service);

    /** Whether what is collected fails the statement that called. At first it does not. Any thread, real-time safe. */
    static void setStrict(bool yes) noexcept;
    static bool isStrict() noexcept;

private:
    FailureReport* const outer_;
    std::string reasons_;
};

/** While one lives, errors that its thread logs are kept here instead, to become a reason. What nobody takes is logged at its
    end. On the stack. */
class RTT_API KeptErrors {
public:
    KeptErrors() noexcept;
    ~KeptErrors();
    KeptErrors(const KeptErrors&) = delete;
    KeptErrors& operator=(const KeptErrors&) = delete;

    /** The texts of the lines, separated by semicolons. */
    std::string take() { return std::exchange(text_, {}); }
    /** For the log: false if nobody keeps the errors of this thread. */
    static bool keep(const std::string& line);

private:
    KeptErrors* const outer_;
    std::string text_;
};

}  // namespace internal
}  // namespace RTT

#endif
