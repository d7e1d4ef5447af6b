// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The floor of everything that two threads do in turn: they wake each other by nothing but a futex.
#ifndef OROFORGE_BENCH_FUTEX_FLOOR_HPP
#define OROFORGE_BENCH_FUTEX_FLOOR_HPP

#include "pairs.hpp"

#include <atomic>
#include <cstdint>
#include <ctime>
#include <linux/futex.h>
#include <pthread.h>
#include <sched.h>
#include <sys/syscall.h>
#include <thread>
#include <unistd.h>

namespace bench {

inline void futexWait(const std::atomic<std::uint32_t>& word, std::uint32_t while_) {
    while (word.load(std::memory_order_acquire) == while_)
        syscall(SYS_futex, &word, FUTEX_WAIT_PRIVATE, while_, nullptr, nullptr, 0);
}
inline void futexSet(std::atomic<std::uint32_t>& word, std::uint32_t value) {
    word.store(value, std::memory_order_release);
    syscall(SYS_futex, &word, FUTEX_WAKE_PRIVATE, 1, nullptr, nullptr, 0);
}

constexpr int kRoundTrips = 2000;

/** CPUs of the two threads, as masks; 0 leaves it to the scheduler. */
struct Placement {
    unsigned first, second;
};

inline void place(unsigned mask) {
    if (mask == 0) return;
    cpu_set_t set;
    CPU_ZERO(&set);
    for (unsigned cpu = 0; cpu < 32; ++cpu)
        if (mask & (1u << cpu)) CPU_SET(cpu, &set);
    pthread_setaffinity_np(pthread_self(), sizeof set, &set);
}

/** Seconds for each round trip. */
inline double futexPingPong(Placement where) {
    std::atomic<std::uint32_t> turn{0};
    std::thread other([&] {
        place(where.second);
        for (int i = 0; i < kRoundTrips; ++i) {
            futexWait(turn, 0);
            futexSet(turn, 0);
        }
    });
    double elapsed = 0;
    std::thread server([&] {
        place(where.first);
        usleep(2000);  // until the other one waits
        elapsed = bench::timed(CLOCK_MONOTONIC, [&] {
            for (int i = 0; i < kRoundTrips; ++i) {
                futexSet(turn, 1);
                futexWait(turn, 1);
            }
        });
    });
    server.join();
    other.join();
    return elapsed / kRoundTrips;
}

}  // namespace bench

#endif
