// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/os/threads.hpp>

#include <rtt/os/detail/scheduling.hpp>
#include <rtt/os/detail/thread_list.hpp>
#include <rtt/os/os_log.hpp>

#include <atomic>
#include <linux/capability.h>
#include <mutex>
#include <pwd.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <utility>

namespace RTT::os {

const int LowestPriority = 1;
const int HighestPriority = 99;
const int IncreasePriority = 1;

namespace {

// Tests the capability itself: root in a container may lack it, and other users may have it.
bool maySetAnyPriority() {
    __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
    __user_cap_data_struct data[_LINUX_CAPABILITY_U32S_3] = {};
    if (syscall(SYS_capget, &header, data) != 0) return geteuid() == 0;
    return (data[CAP_TO_INDEX(CAP_SYS_NICE)].effective & CAP_TO_MASK(CAP_SYS_NICE)) != 0;
}

rlim_t priorityLimit() {
    rlimit limit{};
    return getrlimit(RLIMIT_RTPRIO, &limit) == 0 ? limit.rlim_cur : 0;
}

std::string userName() {
    passwd entry, *found = nullptr;
    char text[4096];
    const bool known = getpwuid_r(geteuid(), &entry, text, sizeof text, &found) == 0 && found;
    return known ? found->pw_name : std::to_string(geteuid());
}

std::string threadOf(const std::string& name) { return name.empty() ? "" : "thread '" + name + "': "; }

// A warning about a scheduler also covers its priority: one thread checks both, in this order.
thread_local bool privilegeMissed = false;
std::atomic<bool> privilegeReported{false};

/** Warns once, with the cure; for each further thread there is a line in the log file. */
void reportMissingPrivilege(int scheduler, const std::string& name) {
    const std::string what = threadOf(name) + detail::schedulerName(scheduler) +
                             " needs the capability CAP_SYS_NICE or an rtprio limit above 0, using ORO_SCHED_OTHER";
    if (privilegeReported.exchange(true)) return detail::log(detail::LogInfo, "Thread", what);
    detail::log(detail::LogWarning, "Thread",
                what + "; the cure: a file in /etc/security/limits.d with the line '" + userName() +
                    " - rtprio 99', and to log in again (systemd: LimitRTPRIO=99); this is reported once");
}

bool force(int& priority, int value, const std::string& name, const std::string& why) {
    detail::log(
        detail::LogWarning, "Thread",
        threadOf(name) + "priority " + std::to_string(priority) + " " + why + ", using " + std::to_string(value));
    priority = value;
    return false;
}

}  // namespace

bool CheckScheduler(int& scheduler) { return detail::checkScheduler(scheduler, std::string()); }
bool CheckPriority(int& scheduler, int& priority) { return detail::checkPriority(scheduler, priority, std::string()); }

bool detail::checkScheduler(int& scheduler, const std::string& name) {
    privilegeMissed = false;
    if (scheduler == ORO_SCHED_OTHER) return true;
    if (scheduler != SCHED_FIFO && scheduler != SCHED_RR) {
        detail::log(detail::LogError, "Thread",
                    threadOf(name) + "unknown scheduler " + std::to_string(scheduler) +
                        ", expected ORO_SCHED_RT or ORO_SCHED_OTHER; using ORO_SCHED_OTHER");
        scheduler = ORO_SCHED_OTHER;
        return false;
    }
    if (maySetAnyPriority() || priorityLimit() != 0) return true;
    reportMissingPrivilege(scheduler, name);
    privilegeMissed = true;
    scheduler = ORO_SCHED_OTHER;
    return false;
}

bool detail::checkPriority(int& scheduler, int& priority, const std::string& name) {
    const bool missed = std::exchange(privilegeMissed, false);
    if (scheduler == ORO_SCHED_OTHER) {
        if (priority == 0) return true;
        if (missed) priority = LowestPriority;
        // Callers that do not care pass LowestPriority.
        if (priority != LowestPriority) return force(priority, 0, name, "has no meaning for ORO_SCHED_OTHER");
        priority = 0;
        return false;
    }
    if (priority <= 0) return force(priority, LowestPriority, name, "is too low for a real-time thread");
    bool fits = true;
    if (priority > HighestPriority) fits = force(priority, HighestPriority, name, "is too high for a real-time thread");
    if (!maySetAnyPriority() && priorityLimit() != RLIM_INFINITY && static_cast<rlim_t>(priority) > priorityLimit())
        fits = force(priority, static_cast<int>(priorityLimit()), name, "is above the rtprio limit of this user");
    return fits;
}

namespace {

struct ThreadList {
    std::mutex mutex;
    std::vector<threads::Info> entries;
};

// Never destroyed: threads of static objects end when everything else is gone.
ThreadList& threadList() {
    static ThreadList& list = *new ThreadList;
    return list;
}

}  // namespace

namespace detail {

int addThread(const char* name, unsigned pid) {
    ThreadList& list = threadList();
    std::lock_guard<std::mutex> lock(list.mutex);
    int number = 0;
    auto at = list.entries.begin();  // sorted by number: the first gap is the smallest free number
    while (at != list.entries.end() && at->number == number) {
        ++number;
        ++at;
    }
    list.entries.insert(at, threads::Info{number, pid, name});
    return number;
}

void removeThread(int number) {
    ThreadList& list = threadList();
    std::lock_guard<std::mutex> lock(list.mutex);
    for (auto at = list.entries.begin(); at != list.entries.end(); ++at)
        if (at->number == number) {
            list.entries.erase(at);
            return;
        }
}

}  // namespace detail

std::vector<threads::Info> threads::list() {
    ThreadList& list = threadList();
    std::lock_guard<std::mutex> lock(list.mutex);
    return list.entries;
}

std::size_t threads::count() { return list().size(); }

}  // namespace RTT::os
