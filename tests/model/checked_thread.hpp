// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// os::Thread with a thread of the checker's: the runtime's sources, and nothing where they ask the system for something.
// To be included after checker/substitute.hpp. Such a thread begins when the scenario calls Thread::run() in one of its own.
#ifndef OROFORGE_MODEL_CHECKED_THREAD_HPP
#define OROFORGE_MODEL_CHECKED_THREAD_HPP

#include <rtt/os/fosi.h>
#define rtos_get_time_ns() NANO_TIME(0)  // time stands still
#define pthread_join(thread, result) static_cast<void>(0)
#define pthread_setname_np(thread, name) static_cast<void>(0)
#include <rtt/os/Thread.cpp>
#include <rtt/os/ThreadInterface.cpp>
#include <rtt/os/ThreadSession.cpp>
#include <rtt/os/ThreadStartStop.cpp>

namespace RTT {
namespace os {
// There is nothing to schedule.
const int LowestPriority = 1;
bool inRealTimeThread() noexcept { return false; }
namespace detail {
bool checkScheduler(int&, const std::string&) { return true; }
bool checkPriority(int&, int&, const std::string&) { return true; }
int addThread(const char*, unsigned) { return 0; }
void removeThread(int) {}
void log(LogLevel, const char*, std::string_view) {}
void beginRealTimeThread() {}
void noteRealTimeWanted(const ThreadInterface&, bool) noexcept {}
const char* schedulerName(int) noexcept { return ""; }
bool applyScheduling(pthread_t, int, int, const std::string&) { return true; }
bool applyAffinity(pid_t, unsigned, const std::string&) { return true; }
unsigned affinityOf(pid_t) noexcept { return 0; }
std::string shortThreadName(const std::string& name) { return name; }
int createThread(pthread_t&, int&, int&, unsigned, void* (*)(void*), void*, const std::string&) { return 0; }
pid_t idOf(pthread_t) noexcept { return 0; }
}  // namespace detail
}  // namespace os
}  // namespace RTT

#endif
