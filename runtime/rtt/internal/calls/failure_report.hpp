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
 * Collects the reasons of operations that return false, in its thread and while it exists. It serves scripts that
 * ignore the returned value: the script knows the file and the line, the operation the reason. Reports nest. Lives on
 * the stack.
 */
class RTT_API FailureReport {
public:
    FailureReport() noexcept;
    ~FailureReport();
    FailureReport(const FailureReport&) = delete;
    FailureReport& operator=(const FailureReport&) = delete;

    /** All reasons, separated by semicolons; empty if none was given. */
    const std::string& reasons() const noexcept { return reasons_; }
    /** For operations that return false. False if no report collects; the caller then logs the reason. Allocates. */
    static bool give(const std::string& reason);
    /** True if a report collects in this thread. */
    static bool isWanted() noexcept;

    /** While one exists, its thread executes code of other components and collects nothing. Lives on the stack. */
    class RTT_API Pause {
    public:
        Pause() noexcept;
        ~Pause();
        Pause(const Pause&) = delete;
        Pause& operator=(const Pause&) = delete;

    private:
        FailureReport* const paused_;
    };

    /** While one exists, the next queued call executed by its thread gives reasons to `report`. Lives on the stack. */
    class RTT_API OfSent {
    public:
        explicit OfSent(FailureReport& report) noexcept;
        ~OfSent();
        OfSent(const OfSent&) = delete;
        OfSent& operator=(const OfSent&) = delete;
    };

    /** The services whose operations give reasons. Any thread; these functions share a lock. */
    static void add(const Service& service);
    static void remove(const Service& service);
    static bool comesFrom(const Service& service);

    /** Whether a collected reason makes the calling statement fail; false at first. Any thread; real-time safe. */
    static void setStrict(bool yes) noexcept;
    static bool isStrict() noexcept;

private:
    FailureReport* const outer_;
    std::string reasons_;
};

/** While one exists, errors that its thread logs are kept here instead, to become a reason. The destructor logs those
    that take() did not fetch. Lives on the stack. */
class RTT_API KeptErrors {
public:
    KeptErrors() noexcept;
    ~KeptErrors();
    KeptErrors(const KeptErrors&) = delete;
    KeptErrors& operator=(const KeptErrors&) = delete;

    /** The texts of the lines, separated by semicolons. */
    std::string take() { return std::exchange(text_, {}); }
    /** For the log: false if the errors of this thread are not kept. */
    static bool keep(const std::string& line);

private:
    KeptErrors* const outer_;
    std::string text_;
};

}  // namespace internal
}  // namespace RTT

#endif
