// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/os/MainThread.hpp>

#include <rtt/os/detail/scheduling.hpp>
#include <rtt/os/os_log.hpp>
#include <rtt/os/threads.hpp>

#include <cerrno>
#include <cstring>

namespace RTT::os {

MainThread::MainThread() : task_() {
    // May be the first call in another thread: the id of the main thread is that of the process.
    task_.pid = getpid();
    enlist("main", static_cast<unsigned>(task_.pid));
}

ThreadInterface* MainThread::Instance() {
    // Never destroyed: static objects may ask for it when the process ends.
    static MainThread* const instance = new MainThread;
    return instance;
}

void MainThread::Release() {}

namespace {

// By thread id: another thread cannot find out the pthread_t of the main thread.
bool setScheduling(pid_t thread, int scheduler, int priority) {
    sched_param parameters{};
    parameters.sched_priority = priority;
    if (sched_setscheduler(thread, scheduler, &parameters) == 0) return true;
    detail::log(detail::LogWarning, "Thread",
                std::string("thread 'main': cannot change scheduler or priority: ") + std::strerror(errno));
    return false;
}

}  // namespace

bool MainThread::setScheduler(int scheduler) {
    if (!detail::checkScheduler(scheduler, "main")) return false;
    int priority = getPriority();
    if (scheduler == ORO_SCHED_OTHER)
        priority = 0;
    else if (priority == 0)
        priority = LowestPriority;
    return setScheduling(task_.pid, scheduler, priority);
}

int MainThread::getScheduler() const { return sched_getscheduler(task_.pid); }

bool MainThread::setPriority(int priority) {
    int scheduler = getScheduler();
    detail::checkPriority(scheduler, priority, "main");
    return setScheduling(task_.pid, scheduler, priority);
}

int MainThread::getPriority() const {
    sched_param parameters{};
    sched_getparam(task_.pid, &parameters);
    return parameters.sched_priority;
}

bool MainThread::setCpuAffinity(unsigned cpuAffinity) { return detail::applyAffinity(task_.pid, cpuAffinity, "main"); }

unsigned MainThread::getCpuAffinity() const { return detail::affinityOf(task_.pid); }

void MainThread::yield() { sched_yield(); }

}  // namespace RTT::os
