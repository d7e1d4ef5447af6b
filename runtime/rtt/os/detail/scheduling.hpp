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

/** CheckScheduler and CheckPriority for the thread of that name, which begins what they log; nobody's if it is empty. */
bool checkScheduler(int& scheduler, const std::string& name);
bool checkPriority(int& scheduler, int& priority, const std::string& name);

/**
 * Gives a thread scheduler and priority, which CheckScheduler and CheckPriority have seen. False, with a warning
 * that names the thread, if the system refuses.
 */
bool applyScheduling(pthread_t thread, int scheduler, int priority, const std::string& name);

/** Mask 0: every CPU the process was started with. False, with a warning, if no such CPU may be used. */
bool applyAffinity(pid_t thread, unsigned mask, const std::string& name);
/** CPUs 0 to 31 that the thread may use; all bits set if that cannot be found out. */
unsigned affinityOf(pid_t thread) noexcept;

/** At most 15 characters, which is what Linux keeps: of longer names the first and the last seven, joined by '~'. */
std::string shortThreadName(const std::string& name);

/**
 * pthread_create with this scheduler and priority. If the privilege is missing: a warning, both become ORO_SCHED_OTHER
 * and 0, and the thread is created with these. Returns an errno value.
 */
int createThread(pthread_t& thread, int& scheduler, int& priority, unsigned stackSize, void* (*entry)(void*),
                 void* argument, const std::string& name);

}  // namespace detail
}  // namespace os
}  // namespace RTT
#endif
