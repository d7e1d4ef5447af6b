// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_THREADS_HPP
#define ORO_OS_THREADS_HPP

#include <rtt/os/fosi.h>

#include <string>
#include <vector>

namespace RTT {
namespace os {

/** Priorities of real-time threads: 1 is the lowest, 99 the highest, and more is more urgent. */
extern RTT_API const int LowestPriority;
extern RTT_API const int HighestPriority;
/** Add this to a priority to make it more urgent. */
extern RTT_API const int IncreasePriority;

/**
 * Makes `scheduler` one that this process may use. Returns false, after logging why, if it had to change it: an unknown
 * one, or a real-time one without the privilege, becomes ORO_SCHED_OTHER.
 */
RTT_API bool CheckScheduler(int& scheduler);

/**
 * Makes `priority` one that fits the scheduler and the privileges of this process. Returns false, after logging
 * why, if it had to change it. Threads of ORO_SCHED_OTHER have priority 0.
 */
RTT_API bool CheckPriority(int& scheduler, int& priority);

/** The threads of the runtime that exist now, the main thread included once MainThread::Instance() was called. */
struct RTT_API threads {
    struct Info {
        int number;   /**< small number, reused after the thread has ended */
        unsigned pid; /**< Linux thread id */
        std::string name;
    };
    static std::vector<Info> list();
    static std::size_t count();
};

}  // namespace os
}  // namespace RTT
#endif
