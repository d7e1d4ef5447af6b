// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/extras/FileDescriptorActivity.hpp>

#include "detail/poll_set.hpp"
#include "detail/poll_waker.hpp"

#include <rtt/os/MutexLock.hpp>
#include <rtt/os/os_log.hpp>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstring>

namespace RTT::extras {

namespace {

// Signals to the thread.
constexpr std::uint32_t kTriggered = 1u;
constexpr std::uint32_t kTimedOut = 2u;
constexpr std::uint32_t kNewTimeout = 4u;
constexpr std::uint32_t kLook = 8u;  // the set has changed, or the session must end

int clamped(nsecs value) { return static_cast<int>(std::min<nsecs>(value, INT_MAX)); }

void logError(const os::Thread& thread, const std::string& text) {
    os::detail::log(os::detail::LogError, "FileDescriptorActivity", "'" + std::string(thread.getName()) + "': " + text);
}

}  // namespace

FileDescriptorActivityInterface::~FileDescriptorActivityInterface() = default;

struct FileDescriptorActivity::Descriptors {
    detail::PollSet set;
    detail::PollWaker waker;
    os::Mutex opening;
    std::atomic<nsecs> timeout{0};  // 0 for none
    std::atomic<bool> timedOut{false};
    std::atomic<bool> failed{false};
    std::atomic<bool> executing{false};
    std::atomic<bool> quit{false};  // the object is being destroyed

    // Used only by the thread.
    nsecs deadline = InfiniteNSecs;
    bool failureReported = false;

    bool mayWait(bool mayRun) const { return mayRun && !quit; }
    void arm(nsecs now) {
        const nsecs wait = timeout;
        deadline = wait != 0 && wait < InfiniteNSecs - now ? now + wait : InfiniteNSecs;
    }
    void note(const detail::PollResult& found, std::uint32_t signals, nsecs now) {
        if (signals & kNewTimeout) arm(now);
        timedOut = !found.ready && now >= deadline;
        failed = found.error != 0 || found.closed >= 0;
    }
};

/** Marks that the thread executes user code. */
class FileDescriptorActivity::Execution {
public:
    explicit Execution(Descriptors& descriptors) : executing_(descriptors.executing) { executing_ = true; }
    ~Execution() { executing_ = false; }
    Execution(const Execution&) = delete;
    Execution& operator=(const Execution&) = delete;

private:
    std::atomic<bool>& executing_;
};

FileDescriptorActivity::FileDescriptorActivity(int priority, base::RunnableInterface* r, const std::string& name)
    : FileDescriptorActivity(ORO_SCHED_RT, priority, 0.0, 0, r, name) {}
FileDescriptorActivity::FileDescriptorActivity(int scheduler, int priority, base::RunnableInterface* r,
                                               const std::string& name)
    : FileDescriptorActivity(scheduler, priority, 0.0, 0, r, name) {}
FileDescriptorActivity::FileDescriptorActivity(int scheduler, int priority, Seconds period, base::RunnableInterface* r,
                                               const std::string& name)
    : FileDescriptorActivity(scheduler, priority, period, 0, r, name) {}
FileDescriptorActivity::FileDescriptorActivity(int scheduler, int priority, Seconds period, unsigned cpuAffinity,
                                               base::RunnableInterface* r, const std::string& name)
    : Activity(scheduler, priority, period, cpuAffinity, nullptr, name), descriptors_(new Descriptors) {
    (void)FileDescriptorActivity::setPeriod(period);
    adopt(r);
}

FileDescriptorActivity::~FileDescriptorActivity() {
    closeGate();
    stop();
    // If a step did not end in time, stop() has failed, and the step must not be followed by another wait.
    descriptors_->quit = true;
    descriptors_->waker.post(kLook);
    terminate();
}

void FileDescriptorActivity::watch(int fd) {
    if (fd < 0)
        logError(*this, "cannot watch file descriptor " + std::to_string(fd) + ", expected one that is not negative");
    else if (descriptors_->set.add(fd))
        descriptors_->waker.post(kLook);
}

void FileDescriptorActivity::unwatch(int fd) {
    if (descriptors_->set.remove(fd)) descriptors_->waker.post(kLook);
}

void FileDescriptorActivity::clearAllWatches() {
    descriptors_->set.clear();
    descriptors_->waker.post(kLook);
}

bool FileDescriptorActivity::isWatched(int fd) const { return descriptors_->set.contains(fd); }
bool FileDescriptorActivity::isUpdated(int fd) const { return descriptors_->set.isReady(fd); }
bool FileDescriptorActivity::hasTimeout() const { return descriptors_->timedOut; }
bool FileDescriptorActivity::hasError() const { return descriptors_->failed; }

void FileDescriptorActivity::setTimeout(int milliseconds) {
    if (milliseconds < 0) {
        logError(*this,
                 "invalid timeout of " + std::to_string(milliseconds) + " ms, expected one that is not negative");
        return;
    }
    descriptors_->timeout = nsecs(milliseconds) * 1000000;
    descriptors_->waker.post(kNewTimeout);
}

void FileDescriptorActivity::setTimeout_us(int microseconds) {
    if (microseconds < 0) {
        logError(*this,
                 "invalid timeout of " + std::to_string(microseconds) + " us, expected one that is not negative");
        return;
    }
    descriptors_->timeout = nsecs(microseconds) * 1000;
    descriptors_->waker.post(kNewTimeout);
}

int FileDescriptorActivity::getTimeout() const { return clamped(descriptors_->timeout / 1000000); }
int FileDescriptorActivity::getTimeout_us() const { return clamped(descriptors_->timeout / 1000); }

bool FileDescriptorActivity::isRunning() const { return Activity::isRunning() && descriptors_->executing; }
bool FileDescriptorActivity::isPeriodic() const { return false; }
Seconds FileDescriptorActivity::getPeriod() const { return nsecs_to_Seconds(nominalPeriod_); }
nsecs FileDescriptorActivity::getPeriodNS() const { return nominalPeriod_; }

bool FileDescriptorActivity::setPeriod(Seconds period) {
    if (!(period >= 0)) return false;
    nominalPeriod_ = Seconds_to_nsecs(period);
    return true;
}

bool FileDescriptorActivity::start() {
    if (isActive()) return false;
    {
        os::MutexLock lock(descriptors_->opening);
        if (!descriptors_->waker.open()) {
            logError(*this, std::string("cannot start: no event descriptor: ") + std::strerror(errno));
            return false;
        }
    }
    if (!Activity::start()) return false;
    if (isSelf())  // stopped and started within its session, which would not notice
        descriptors_->waker.post(kTriggered);
    return true;
}

bool FileDescriptorActivity::initialize() {
    descriptors_->waker.forget();  // not active yet; later signals are kept
    return Activity::initialize();
}

bool FileDescriptorActivity::trigger() {
    if (!isActive()) return false;
    descriptors_->waker.post(kTriggered);
    return true;
}

bool FileDescriptorActivity::timeout() {
    if (!isActive()) return false;
    descriptors_->waker.post(kTimedOut);
    return true;
}

bool FileDescriptorActivity::breakLoop() {
    descriptors_->waker.post(kLook);
    return true;
}

void FileDescriptorActivity::session() {
    UserCode mark(*this);  // stop() calls breakLoop() from here on
    Descriptors& d = *descriptors_;
    d.set.forgetReady();
    d.timedOut = false;
    d.failed = false;
    if (d.mayWait(mayRun())) {
        const Execution execution(d);
        work(base::RunnableInterface::Trigger);
    }
    d.arm(rtos_get_time_ns());
    std::uint32_t signals = 0;
    while (d.mayWait(mayRun())) {
        const bool sleeps = signals == 0 && d.waker.prepare();
        const detail::PollResult found = d.set.wait(d.waker.fd(), sleeps ? d.deadline : 0);
        if (found.woken) d.waker.drain();
        signals |= d.waker.take();
        if (found.changed) continue;
        if (!mayRun()) return;
        d.note(found, signals, rtos_get_time_ns());
        reportFailure(found);
        executeDue(found.ready, signals);
        signals = 0;
    }
}

void FileDescriptorActivity::executeDue(bool ready, std::uint32_t signals) {
    Descriptors& d = *descriptors_;
    const bool timeOut = d.timedOut || (signals & kTimedOut);
    if (!timeOut && !d.failed && !ready && !(signals & kTriggered)) return;
    {
        const Execution execution(d);
        step();
        work(timeOut             ? base::RunnableInterface::TimeOut
             : d.failed || ready ? base::RunnableInterface::IOReady
                                 : base::RunnableInterface::Trigger);
    }
    // The timeout begins when it waits again, so that a long step does not count.
    if (timeOut || ready) d.arm(rtos_get_time_ns());
}

void FileDescriptorActivity::reportFailure(const detail::PollResult& found) {
    if (found.closed >= 0)
        logError(*this, "file descriptor " + std::to_string(found.closed) + " is not open, it is not watched any more");
    // Reported once, not at each attempt.
    if (found.error != 0 && !descriptors_->failureReported)
        logError(*this, std::string("cannot wait for the file descriptors: ") + std::strerror(found.error));
    descriptors_->failureReported = found.error != 0;
}

}  // namespace RTT::extras
