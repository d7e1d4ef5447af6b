// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/os/real_time_wanted.hpp>

#include <rtt/os/ThreadInterface.hpp>

#include <atomic>

namespace RTT::os {

namespace {

// Indexed by thread number. Accessed relaxed, because nothing else depends on it.
constexpr int kThreads = 4096;
std::atomic<bool> wantedByNumber[kThreads];

std::atomic<bool>* entryOf(const ThreadInterface& thread) noexcept {
    const int number = thread.threadNumber();
    return number >= 0 && number < kThreads ? &wantedByNumber[number] : nullptr;
}

}  // namespace

bool realTimeWanted(const ThreadInterface& thread) noexcept {
    const std::atomic<bool>* const entry = entryOf(thread);
    if (entry && entry->load(std::memory_order_relaxed)) return true;
    return thread.getScheduler() != ORO_SCHED_OTHER;
}

void detail::noteRealTimeWanted(const ThreadInterface& thread, bool wanted) noexcept {
    if (std::atomic<bool>* const entry = entryOf(thread)) entry->store(wanted, std::memory_order_relaxed);
}

}  // namespace RTT::os
