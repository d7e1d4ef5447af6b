// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "futex_count.hpp"

#include <atomic>
#include <cstdarg>
#include <dlfcn.h>
#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

typedef long (*Syscall)(long, ...);
Syscall real() {
    static std::atomic<Syscall> found{nullptr};
    Syscall function = found.load(std::memory_order_relaxed);
    if (!function) {
        function = reinterpret_cast<Syscall>(dlsym(RTLD_NEXT, "syscall"));
        found.store(function, std::memory_order_relaxed);
    }
    return function;
}

struct Sleeper {
    std::atomic<int> tid{0};
    std::atomic<bool> asleep{false};
};
constexpr int kSleepers = 1024;  // threads of one test program, those that have ended included
Sleeper sleepers[kSleepers];
std::atomic<long> wakes{0};

Sleeper* find(int tid) {
    for (Sleeper& sleeper : sleepers)
        if (sleeper.tid == tid) return &sleeper;
    return nullptr;
}

Sleeper* mine() {
    static thread_local Sleeper* own = nullptr;
    for (int i = 0; !own && i != kSleepers; ++i) {
        int nobody = 0;
        if (sleepers[i].tid.compare_exchange_strong(nobody, gettid())) own = &sleepers[i];
    }
    return own;
}

}  // namespace

namespace oroforge::test {
long futexWakes() { return wakes; }
bool isAsleep(int tid) {
    const Sleeper* sleeper = find(tid);
    return sleeper && sleeper->asleep;
}
}  // namespace oroforge::test

extern "C" long syscall(long number, ...) noexcept {
    long a[6];
    va_list list;
    va_start(list, number);
    for (long& argument : a) argument = va_arg(list, long);
    va_end(list);
    const auto pass = [&] { return real()(number, a[0], a[1], a[2], a[3], a[4], a[5]); };
    if (number != SYS_futex) return pass();
    const long operation = a[1] & FUTEX_CMD_MASK;
    if (operation == FUTEX_WAKE) ++wakes;
    if (operation != FUTEX_WAIT && operation != FUTEX_WAIT_BITSET) return pass();
    Sleeper* const sleeper = mine();
    if (!sleeper) return pass();
    sleeper->asleep = true;
    const long result = pass();
    sleeper->asleep = false;
    return result;
}
