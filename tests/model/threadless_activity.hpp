// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A SequentialActivity and what activities without a thread of their own have in common: the runtime's sources, and
// another thread where they ask for the main thread. To be included after checker/substitute.hpp.
#ifndef OROFORGE_MODEL_THREADLESS_ACTIVITY_HPP
#define OROFORGE_MODEL_THREADLESS_ACTIVITY_HPP

#include <rtt/os/fosi.h>
#define rtos_get_time_ns() NANO_TIME(0)  // time stands still
#include <model/checked_presence.hpp>
#include <rtt/base/ActivityInterface.cpp>
#include <rtt/base/DisposableInterface.cpp>
#include <rtt/base/RunnableInterface.cpp>
#include <rtt/extras/SequentialActivity.cpp>
#include <rtt/internal/engine/access_gate.cpp>
#include <rtt/os/ThreadInterface.cpp>

/** The main thread, which executes nothing here. */
struct OtherThread final : RTT::os::ThreadInterface {
    bool isSelf() const override { return false; }
    bool start() override { return false; }
    bool stop() override { return false; }
    bool isRunning() const override { return false; }
    bool isActive() const override { return false; }
    bool setPeriod(RTT::Seconds) override { return false; }
    RTT::Seconds getPeriod() const override { return 0; }
    RTT::nsecs getPeriodNS() const override { return 0; }
    const char* getName() const override { return "main"; }
    RTOS_TASK* getTask() override { return nullptr; }
    const RTOS_TASK* getTask() const override { return nullptr; }
    unsigned int getPid() const override { return 0; }
    bool setScheduler(int) override { return false; }
    int getScheduler() const override { return 0; }
    bool setPriority(int) override { return false; }
    int getPriority() const override { return 0; }
    bool setCpuAffinity(unsigned) override { return false; }
    unsigned getCpuAffinity() const override { return 0; }
    void yield() override {}
    void setMaxOverrun(int) override {}
    int getMaxOverrun() const override { return 0; }
    void setWaitPeriodPolicy(int) override {}
    void setStopTimeout(RTT::Seconds) override {}
    RTT::Seconds getStopTimeout() const override { return 0; }
} otherThread;

// Volatile, so that the compiler does not know what it is.
RTT::os::ThreadInterface* volatile mainThread = &otherThread;
RTT::os::ThreadInterface* RTT::os::MainThread::Instance() { return mainThread; }
int RTT::os::detail::addThread(const char*, unsigned) { return 0; }
void RTT::os::detail::removeThread(int) {}

#endif
