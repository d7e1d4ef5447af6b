// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_THREADS_HPP
#define ORO_OS_THREADS_HPP

#include <rtt/os/fosi.h>

#include <string>
#include <vector>

namespace RTT {
namespace os {

/** Priorities of real-time threads: 1 is the lowest, 99 the highest and most urgent. */
extern RTT_API const int LowestPriority;
extern RTT_API const int HighestPriority;
/** Add this to a priority to make it more urgent. */
extern RTT_API const int IncreasePriority;

/**
 * Replaces a scheduler that is unknown, or is a real-time scheduler without the privilege, by ORO_SCHED_OTHER. If it
 * did so, logs why and returns false.
 */
RTT_API bool CheckScheduler(int& scheduler);

/**
 * Replaces a priority that the scheduler or the privileges of this process do not allow. If it did so, logs why and
 * returns false. Threads of ORO_SCHED_OTHER have priority 0.
 */
RTT_API bool CheckPriority(int& scheduler, int& priority);

/** The existing threads of the runtime, including the main thread once MainThread::Instance() was called. */
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
