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
 * the first that applies; isUpdated() tells about descriptors in each of them. After start(), work(Trigger) is executed
 * once, for messages that came earlier. Any number of descriptors with any number can be watched.
 *
 * Triggers do not postpone the time of setTimeout(); steps because of ready descriptors or of a timeout do, it begins when they
 * are over. hasTimeout() is true only after that time, not after timeout(). A watched descriptor that turns out to be closed
 * is reported once: hasError() is true in that step, and it is not watched any more.
 *
 * trigger() and timeout() are real-time safe: one atomic operation, and one system call only if the thread sleeps. The
 * functions about descriptors take a mutex for a short time; the thread allocates only after a change of what is watched.
 * A sub-class calls stop() in its destructor.
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
    /** False if active already; forgets a timeout() that came before. */
    bool start() override;
    /** False if not active. */
    bool trigger() override;
    /** False if not active. */
    bool timeout() override;
    /** False: this activity is driven by events, whatever its nominal period. */
    bool isPeriodic() const override;
    Seconds getPeriod() const override;
    nsecs getPeriodNS() const override;
    /** Any value that is not negative, at any time. */
    bool setPeriod(Seconds period) override;

protected:
    bool initialize() override;
    /** Wakes the thread from its wait; one that overrides it must call it. */
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
