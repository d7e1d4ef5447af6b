// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_OS_DETAIL_SCHEDULING_HPP
#define RTT_OS_DETAIL_SCHEDULING_HPP

#include <rtt/os/fosi.h>

#include <string>

/** @file Scheduler, priority, CPU affinity and name of threads of the operating system. */
namespace RTT {
namespace os {
namespace detail {

const char* schedulerName(int scheduler) noexcept;

/** CheckScheduler and CheckPriority, whose messages begin with the name of the thread unless it is empty. */
bool checkScheduler(int& scheduler, const std::string& name);
bool checkPriority(int& scheduler, int& priority, const std::string& name);

/**
 * Sets scheduler and priority of a thread, which CheckScheduler and CheckPriority have checked. If the system refuses,
 * logs a warning that names the thread and returns false.
 */
bool applyScheduling(pthread_t thread, int scheduler, int priority, const std::string& name);

/** Mask 0 means every CPU with which the process started. Logs a warning and returns false if no such CPU may be
    used. */
bool applyAffinity(pid_t thread, unsigned mask, const std::string& name);
/** CPUs 0 to 31 that the thread may use; all bits set if that cannot be found out. */
unsigned affinityOf(pid_t thread) noexcept;

/** The name cut to the 15 characters that Linux keeps: of a longer one the first and last seven, joined by '~'. */
std::string shortThreadName(const std::string& name);

/**
 * Calls pthread_create with this scheduler and priority. If the privilege is missing, logs a warning, sets them to
 * ORO_SCHED_OTHER and 0, and creates the thread with these. Returns an errno value.
 */
int createThread(pthread_t& thread, int& scheduler, int& priority, unsigned stackSize, void* (*entry)(void*),
                 void* argument, const std::string& name);
/** The Linux id of a thread that was created and not yet joined. Does not wait until it runs. */
pid_t idOf(pthread_t thread) noexcept;

}  // namespace detail
}  // namespace os
}  // namespace RTT
#endif
