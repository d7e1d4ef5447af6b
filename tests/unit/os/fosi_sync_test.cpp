// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "os_test.hpp"

#include <rtt/os/fosi.h>

#include <thread>

namespace {

constexpr NANO_TIME kShort = 5000000;

NANO_TIME soon() { return rtos_get_time_ns() + kShort; }

}  // namespace

TEST(LowestLayer, MutexesExcludeAndWaitUntilATime) {
    rt_mutex_t mutex;
    ASSERT_EQ(rtos_mutex_init(&mutex), 0);
    EXPECT_EQ(rtos_mutex_lock(&mutex), 0);
    std::thread([&] {
        EXPECT_NE(rtos_mutex_trylock(&mutex), 0);
        const NANO_TIME until = soon();
        EXPECT_EQ(rtos_mutex_lock_until(&mutex, until), ETIMEDOUT);
        EXPECT_GE(rtos_get_time_ns(), until);
    }).join();
    EXPECT_EQ(rtos_mutex_unlock(&mutex), 0);
    EXPECT_EQ(rtos_mutex_lock_until(&mutex, soon()), 0);
    EXPECT_EQ(rtos_mutex_unlock(&mutex), 0);
    EXPECT_EQ(rtos_mutex_destroy(&mutex), 0);
}

TEST(LowestLayer, RecursiveMutexesAreLockedSeveralTimes) {
    rt_rec_mutex_t mutex;
    ASSERT_EQ(rtos_mutex_rec_init(&mutex), 0);
    EXPECT_EQ(rtos_mutex_rec_lock(&mutex), 0);
    EXPECT_EQ(rtos_mutex_rec_trylock(&mutex), 0);
    EXPECT_EQ(rtos_mutex_rec_lock_until(&mutex, soon()), 0);
    for (int i = 0; i != 2; ++i) rtos_mutex_rec_unlock(&mutex);
    std::thread([&] { EXPECT_NE(rtos_mutex_rec_trylock(&mutex), 0); }).join();
    rtos_mutex_rec_unlock(&mutex);
    EXPECT_EQ(rtos_mutex_rec_destroy(&mutex), 0);
}

TEST(LowestLayer, ConditionsWakeOrTimeOut) {
    rt_mutex_t mutex;
    rt_cond_t condition;
    rtos_mutex_init(&mutex);
    ASSERT_EQ(rtos_cond_init(&condition), 0);
    bool set = false;
    rtos_mutex_lock(&mutex);
    EXPECT_EQ(rtos_cond_timedwait(&condition, &mutex, soon()), ETIMEDOUT);
    std::thread setter([&] {
        rtos_mutex_lock(&mutex);
        set = true;
        rtos_cond_broadcast(&condition);
        rtos_mutex_unlock(&mutex);
    });
    while (!set) EXPECT_EQ(rtos_cond_wait(&condition, &mutex), 0);
    rtos_mutex_unlock(&mutex);
    setter.join();
    EXPECT_EQ(rtos_cond_destroy(&condition), 0);
    rtos_mutex_destroy(&mutex);
}

TEST(LowestLayer, SemaphoresCount) {
    rt_sem_t semaphore;
    ASSERT_EQ(rtos_sem_init(&semaphore, 1), 0);
    EXPECT_EQ(rtos_sem_wait(&semaphore), 0);
    EXPECT_NE(rtos_sem_trywait(&semaphore), 0);
    const NANO_TIME until = soon();
    EXPECT_NE(rtos_sem_wait_until(&semaphore, until), 0);
    EXPECT_GE(rtos_get_time_ns(), until);
    EXPECT_NE(rtos_sem_wait_timed(&semaphore, kShort), 0);
    EXPECT_EQ(rtos_sem_signal(&semaphore), 0);
    EXPECT_EQ(rtos_sem_value(&semaphore), 1);
    EXPECT_EQ(rtos_sem_wait_timed(&semaphore, kShort), 0);
    EXPECT_EQ(rtos_sem_destroy(&semaphore), 0);
}
