// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/os/detail/scheduling.hpp>

#include <rtt/os/os_log.hpp>
#include <rtt/os/real_time_thread.hpp>

#include <cerrno>
#include <cstring>

namespace RTT::os {

bool inRealTimeThread() noexcept {
    switch (sched_getscheduler(0) & ~SCHED_RESET_ON_FORK) {
        case SCHED_FIFO:
        case SCHED_RR:
        case SCHED_DEADLINE: return true;
        default: return false;  // also an error, -1
    }
}

namespace detail {

namespace {

// Read once: later the main thread may be bound to one CPU, and new threads would inherit that from their maker.
const cpu_set_t& processAffinity() {
    static const cpu_set_t all = [] {
        cpu_set_t set;
        CPU_ZERO(&set);
        if (sched_getaffinity(getpid(), sizeof set, &set) != 0)
            for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu) CPU_SET(cpu, &set);
        return set;
    }();
    return all;
}

void warn(const std::string& name, const std::string& what, int error) {
    log(LogWarning, "Thread", "thread '" + name + "': " + what + ": " + std::strerror(error));
}

std::string describe(int scheduler, int priority) {
    return std::string(schedulerName(scheduler)) + " with priority " + std::to_string(priority);
}

}  // namespace

const char* schedulerName(int scheduler) noexcept {
    switch (scheduler) {
        case SCHED_OTHER: return "ORO_SCHED_OTHER";
        case SCHED_FIFO: return "ORO_SCHED_RT";
        case SCHED_RR: return "SCHED_RR";
        default: return "unknown scheduler";
    }
}

bool applyScheduling(pthread_t thread, int scheduler, int priority, const std::string& name) {
    sched_param parameters{};
    parameters.sched_priority = priority;
    const int error = pthread_setschedparam(thread, scheduler, &parameters);
    if (error != 0) warn(name, "cannot change to " + describe(scheduler, priority), error);
    return error == 0;
}

bool applyAffinity(pid_t thread, unsigned mask, const std::string& name) {
    cpu_set_t set = processAffinity();
    if (mask != 0) {
        CPU_ZERO(&set);
        for (unsigned cpu = 0; cpu < 8 * sizeof mask; ++cpu)
            if (mask & (1u << cpu)) CPU_SET(cpu, &set);
    }
    cpu_set_t present;
    if (sched_getaffinity(thread, sizeof present, &present) == 0 && CPU_EQUAL(&present, &set)) return true;
    if (sched_setaffinity(thread, sizeof set, &set) == 0) return true;
    warn(name, "cannot use the CPU mask " + std::to_string(mask), errno);
    return false;
}

unsigned affinityOf(pid_t thread) noexcept {
    cpu_set_t set;
    CPU_ZERO(&set);
    if (sched_getaffinity(thread, sizeof set, &set) != 0) return ~0u;
    unsigned mask = 0;
    for (unsigned cpu = 0; cpu < 8 * sizeof mask; ++cpu)
        if (CPU_ISSET(cpu, &set)) mask |= 1u << cpu;
    return mask;
}

std::string shortThreadName(const std::string& name) {
    return name.size() <= 15 ? name : name.substr(0, 7) + "~" + name.substr(name.size() - 7);
}

// The C library has no function for it. A thread is known to the kernel before its maker continues, and Linux composes
// the id of a thread's CPU clock of its id and three bits.
pid_t idOf(pthread_t thread) noexcept {
    clockid_t clock = 0;
    return pthread_getcpuclockid(thread, &clock) == 0 ? ~(clock >> 3) : 0;
}

int createThread(pthread_t& thread, int& scheduler, int& priority, unsigned stackSize, void* (*entry)(void*),
                 void* argument, const std::string& name) {
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    if (stackSize != 0 && pthread_attr_setstacksize(&attributes, stackSize) != 0)
        warn(name, "cannot have a stack of " + std::to_string(stackSize) + " bytes, using the default", EINVAL);
    const auto attempt = [&] {
        sched_param parameters{};
        parameters.sched_priority = priority;
        // A thread made by a real-time thread would inherit real-time scheduling. Otherwise inheriting saves a wait for
        // the maker.
        const bool inherits = scheduler == SCHED_OTHER && sched_getscheduler(0) == SCHED_OTHER;
        pthread_attr_setinheritsched(&attributes, inherits ? PTHREAD_INHERIT_SCHED : PTHREAD_EXPLICIT_SCHED);
        pthread_attr_setschedpolicy(&attributes, scheduler);
        pthread_attr_setschedparam(&attributes, &parameters);
        return pthread_create(&thread, &attributes, entry, argument);
    };
    int error = attempt();
    // Even root may be refused: in a container, or under CONFIG_RT_GROUP_SCHED without a budget.
    if (error == EPERM && scheduler != ORO_SCHED_OTHER) {
        warn(name, "cannot have " + describe(scheduler, priority) + ", using ORO_SCHED_OTHER", error);
        scheduler = ORO_SCHED_OTHER;
        priority = 0;
        error = attempt();
    }
    pthread_attr_destroy(&attributes);
    return error;
}

}  // namespace detail
}  // namespace RTT::os
