// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_EXTRAS_FILE_DESCRIPTOR_ACTIVITY_HPP
#define ORO_EXTRAS_FILE_DESCRIPTOR_ACTIVITY_HPP

#include <rtt/Activity.hpp>
#include <rtt/extras/FileDescriptorActivityInterface.hpp>

#include <memory>

namespace RTT {
namespace extras {
namespace detail {
struct PollResult;
}

/**
 * An activity whose thread waits for file descriptors. Each wake-up executes step() and work() once, with
 *
 *     TimeOut   after timeout() or when the time of setTimeout() is over
 *     IOReady   if descriptors are ready, or waiting failed
 *     Trigger   after trigger() alone
 *
 * the first reason that applies; isUpdated() is valid with each of them. After start(), work(Trigger) is executed once,
 * for earlier messages. It can watch any number of descriptors, with any values.
 *
 * The time of setTimeout() begins again after each step because of ready descriptors or a timeout, but not after
 * triggers. hasTimeout() is true only after that time, not after timeout(). A watched descriptor that is closed is
 * reported once, with hasError() true in that step, and is not watched any more.
 *
 * trigger() and timeout() are real-time safe: one atomic operation, and one system call only if the thread sleeps.
 * Functions for descriptors lock a mutex for a short time; the thread allocates only after the watched descriptors
 * change. A sub-class must call stop() in its destructor.
 */
class RTT_API FileDescriptorActivity : public Activity, public FileDescriptorActivityInterface {
public:
    /** ORO_SCHED_RT. */
    explicit FileDescriptorActivity(int priority, base::RunnableInterface* r = nullptr,
                                    const std::string& name = "FileDescriptorActivity");
    FileDescriptorActivity(int scheduler, int priority, base::RunnableInterface* r = nullptr,
                           const std::string& name = "FileDescriptorActivity");
    /** The period, in seconds, is only what getPeriod() returns. */
    FileDescriptorActivity(int scheduler, int priority, Seconds period, base::RunnableInterface* r = nullptr,
                           const std::string& name = "FileDescriptorActivity");
    FileDescriptorActivity(int scheduler, int priority, Seconds period, unsigned cpuAffinity,
                           base::RunnableInterface* r = nullptr, const std::string& name = "FileDescriptorActivity");
    ~FileDescriptorActivity() override;

    void watch(int fd) override;
    void unwatch(int fd) override;
    void clearAllWatches() override;
    bool isWatched(int fd) const override;
    bool isUpdated(int fd) const override;
    bool hasTimeout() const override;
    bool hasError() const override;
    void setTimeout(int milliseconds) override;
    void setTimeout_us(int microseconds) override;
    int getTimeout() const override;
    int getTimeout_us() const override;

    /** True while it executes step() or work(), false while it waits. */
    bool isRunning() const override;
    /** False if active already; forgets an earlier timeout(). */
    bool start() override;
    /** False if not active. */
    bool trigger() override;
    /** False if not active. */
    bool timeout() override;
    /** False: this activity is driven by events, whatever its nominal period. */
    bool isPeriodic() const override;
    Seconds getPeriod() const override;
    nsecs getPeriodNS() const override;
    /** Accepts any value that is not negative, at any time. */
    bool setPeriod(Seconds period) override;

protected:
    bool initialize() override;
    /** Wakes the thread from its wait; an override must call it. */
    bool breakLoop() override;
    void session() override;

private:
    struct Descriptors;
    class Execution;
    void executeDue(bool ready, std::uint32_t signals);
    void reportFailure(const detail::PollResult& found);

    std::unique_ptr<Descriptors> descriptors_;
    std::atomic<nsecs> nominalPeriod_{0};
};

}  // namespace extras
}  // namespace RTT
#endif
