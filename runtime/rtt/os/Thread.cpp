// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/os/Thread.hpp>

#include <rtt/os/detail/scheduling.hpp>
#include <rtt/os/detail/thread_state.hpp>
#include <rtt/os/futex.hpp>
#include <rtt/os/os_log.hpp>
#include <rtt/os/real_time_thread.hpp>
#include <rtt/os/real_time_wanted.hpp>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>

#include <signal.h>
#include <sys/mman.h>

/**
 * @file
 * Creation, properties and end of a thread. ThreadSession.cpp has what it executes, ThreadStartStop.cpp start() and
 * stop().
 */
namespace RTT::os {

namespace {

std::atomic<unsigned> stackSize{0};
std::atomic<double> stopTimeoutNoPeriod{1.0};
std::atomic<double> stopTimeoutPeriods{10.0};

std::string formatted(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

/** Says why no thread can be created. It is a bad_alloc, because callers of the RTT API expect one. */
class NoThread final : public std::bad_alloc {
public:
    explicit NoThread(const std::string& text) : text_(std::make_shared<const std::string>(text)) {}
    const char* what() const noexcept override { return text_->c_str(); }

private:
    std::shared_ptr<const std::string> text_;
};

std::string whyNot(int error) {
    const std::string text = std::strerror(error);
    if (error != EAGAIN) return text;
    return text + " (EAGAIN): the limit of threads (ulimit -u, pids.max of the control group) or of memory is reached";
}

/** A stack for signal handlers of this thread: without it, the exhaustion of its own stack could not be reported. */
class SignalStack {
public:
    SignalStack() {
        stack_t present{};
        // A sanitizer has set one already.
        if (sigaltstack(nullptr, &present) != 0 || !(present.ss_flags & SS_DISABLE)) return;
        // Mapped, so that it takes no memory as long as no handler runs.
        void* const memory =
            mmap(nullptr, kSize, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_STACK, -1, 0);
        if (memory == MAP_FAILED) return;
        stack_t own{};
        own.ss_sp = memory;
        own.ss_size = kSize;
        if (sigaltstack(&own, nullptr) == 0)
            memory_ = memory;
        else
            munmap(memory, kSize);
    }
    ~SignalStack() {
        stack_t present{};
        if (!memory_ || sigaltstack(nullptr, &present) != 0) return;
        stack_t none{};
        none.ss_flags = SS_DISABLE;
        // Code that the thread executed may have set another one.
        if (present.ss_sp == memory_ && sigaltstack(&none, nullptr) != 0) return;
        munmap(memory_, kSize);
    }
    SignalStack(const SignalStack&) = delete;
    SignalStack& operator=(const SignalStack&) = delete;

private:
    static constexpr std::size_t kSize = 64 * 1024;
    void* memory_ = nullptr;
};

}  // namespace

Thread::Thread(int scheduler, int priority, Seconds period, unsigned cpuAffinity, const std::string& name)
    : Thread(scheduler, priority, cpuAffinity, name, period) {
    state_->period = period > 0 ? Seconds_to_nsecs(period) : 0;
}

Thread::Thread(int scheduler, int priority, unsigned cpuAffinity, const std::string& name, Seconds nominalPeriod)
    : state_(new State) {
    state_->name = name.empty() ? "Thread" : name;
    const std::string quoted = "'" + state_->name + "'";
    detail::log(detail::LogInfo, "Thread",
                "creating thread " + quoted + ": " + detail::schedulerName(scheduler) + ", priority " +
                    std::to_string(priority) + ", CPU mask " + std::to_string(cpuAffinity));
    const bool realTime = scheduler == SCHED_FIFO || scheduler == SCHED_RR;
    detail::checkScheduler(scheduler, state_->name);
    detail::checkPriority(scheduler, priority, state_->name);
    const int error =
        detail::createThread(state_->task.thread, scheduler, priority, stackSize, &Thread::entry, this, state_->name);
    if (error != 0) {
        const NoThread failure("cannot create thread " + quoted + ": " + whyNot(error));
        detail::log(detail::LogCritical, "Thread", failure.what());
        throw failure;
    }
    state_->joinable = true;
    state_->scheduler = scheduler;
    state_->priority = priority;
    state_->task.pid = detail::idOf(state_->task.thread);
    // The thread does that as well, for systems without /proc, but perhaps later.
    pthread_setname_np(state_->task.thread, detail::shortThreadName(state_->name).c_str());
    detail::applyAffinity(state_->task.pid, cpuAffinity, state_->name);
    enlist(state_->name.c_str(), getPid());
    detail::noteRealTimeWanted(*this, realTime);
    detail::log(detail::LogInfo, "Thread",
                "created thread " + quoted + ": " + detail::schedulerName(scheduler) + ", priority " +
                    std::to_string(priority) + ", CPU mask " + std::to_string(Thread::getCpuAffinity()) + ", period " +
                    formatted("%g s", nominalPeriod > 0 ? nominalPeriod : 0) + ", PID " + std::to_string(getPid()));
}

Thread::~Thread() {
    // The overrides of a sub-class are already destroyed, so the thread ends without a call.
    state_->running = false;
    terminate();
}

void* Thread::entry(void* self) {
    const SignalStack forHandlers;
    Thread* const thread = static_cast<Thread*>(self);
    pthread_setname_np(pthread_self(), detail::shortThreadName(thread->state_->name).c_str());
    if (inRealTimeThread()) detail::beginRealTimeThread();
    thread->run();
    return nullptr;
}

void Thread::terminate() {
    if (!state_->joinable.exchange(false)) return;
    state_->exit = true;
    state_->running = false;
    wake(kExitReason);
    if (ThreadInterface::isSelf()) {  // not a sub-class's override: a thread that executes for this one may join it
        detail::log(
            detail::LogCritical, "Thread",
            "thread '" + state_->name + "' destroys itself: let another thread do that, this one cannot return");
        pthread_detach(state_->task.thread);
    } else {
        reportIfBusy();
        pthread_join(state_->task.thread, nullptr);
    }
    detail::noteRealTimeWanted(*this, false);  // because another thread may get its number
    delist();
}

// The destructor then waits without limit, so that what the thread executes is not destroyed under it.
void Thread::reportIfBusy() const {
    const nsecs deadline = detail::after(rtos_get_time_ns(), Seconds_to_nsecs(Thread::getStopTimeout()));
    std::uint32_t session = state_->session;
    while ((session & State::kRunning) && detail::futexWait(state_->session, session, deadline))
        session = state_->session;
    if (state_->session & State::kRunning)
        detail::log(
            detail::LogError, "Thread",
            "thread '" + state_->name +
                "' is being destroyed while its loop() or step() executes, and waits for the end of that; a class "
                "that overrides them calls stop() in its destructor");
}

const char* Thread::getName() const { return state_->name.c_str(); }
RTOS_TASK* Thread::getTask() { return &state_->task; }
const RTOS_TASK* Thread::getTask() const { return &state_->task; }
unsigned int Thread::getPid() const { return static_cast<unsigned>(state_->task.pid); }

bool Thread::setScheduler(int scheduler) {
    const bool realTime = scheduler == SCHED_FIFO || scheduler == SCHED_RR;
    if (!detail::checkScheduler(scheduler, state_->name)) {
        if (realTime) detail::noteRealTimeWanted(*this, true);
        return false;
    }
    std::lock_guard<std::mutex> lock(state_->scheduling);
    int priority = state_->priority;
    if (scheduler == ORO_SCHED_OTHER)
        priority = 0;
    else if (priority == 0)
        priority = LowestPriority;
    if (!state_->joinable || !detail::applyScheduling(state_->task.thread, scheduler, priority, state_->name))
        return false;
    state_->scheduler = scheduler;
    state_->priority = priority;
    detail::noteRealTimeWanted(*this, realTime);
    return true;
}

int Thread::getScheduler() const { return state_->scheduler; }

bool Thread::setPriority(int priority) {
    std::lock_guard<std::mutex> lock(state_->scheduling);
    int scheduler = state_->scheduler;
    detail::checkPriority(scheduler, priority, state_->name);
    if (!state_->joinable || !detail::applyScheduling(state_->task.thread, scheduler, priority, state_->name))
        return false;
    state_->priority = priority;
    return true;
}

int Thread::getPriority() const { return state_->priority; }

bool Thread::setCpuAffinity(unsigned cpuAffinity) {
    return state_->joinable && detail::applyAffinity(state_->task.pid, cpuAffinity, state_->name);
}

unsigned Thread::getCpuAffinity() const { return state_->joinable ? detail::affinityOf(state_->task.pid) : ~0u; }

bool Thread::setPeriod(Seconds period) {
    const nsecs ns = Seconds_to_nsecs(period);
    // Periodic and non-periodic threads run different functions, so only an idle thread may change between them.
    if (ns < 0 || (isActive() && (ns == 0) != (state_->period == 0))) return false;
    state_->period = ns;
    return true;
}

bool Thread::setPeriod(secs s, nsecs ns) { return setPeriod(nsecs_to_Seconds(secs_to_nsecs(s) + ns)); }
bool Thread::setPeriod(TIME_SPEC period) { return setPeriod(period.tv_sec, static_cast<nsecs>(period.tv_nsec)); }
Seconds Thread::getPeriod() const { return nsecs_to_Seconds(getPeriodNS()); }
nsecs Thread::getPeriodNS() const { return state_->period; }

void Thread::yield() { sched_yield(); }
void Thread::setMaxOverrun(int maxOverrun) { state_->maxOverrun = maxOverrun; }
int Thread::getMaxOverrun() const { return state_->maxOverrun; }
void Thread::setWaitPeriodPolicy(int policy) { state_->waitPolicy = policy; }
void Thread::setStopTimeout(Seconds timeout) { state_->stopTimeout = Seconds_to_nsecs(timeout); }

Seconds Thread::getStopTimeout() const {
    if (const nsecs set = state_->stopTimeout) return nsecs_to_Seconds(set);
    const nsecs period =
        state_->period;  // not getPeriod(): an Activity waits by itself, so it gets the time of non-periodic threads
    return period == 0 ? stopTimeoutNoPeriod.load() : stopTimeoutPeriods * nsecs_to_Seconds(period);
}

void Thread::setStackSize(unsigned bytes) { stackSize = bytes; }
void Thread::setLockTimeoutNoPeriod(double seconds) { stopTimeoutNoPeriod = seconds; }
void Thread::setLockTimeoutPeriodFactor(double periods) { stopTimeoutPeriods = periods; }

}  // namespace RTT::os
