// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_MAIN_THREAD_HPP
#define ORO_OS_MAIN_THREAD_HPP

#include <rtt/os/ThreadInterface.hpp>

namespace RTT {
namespace os {

/**
 * The thread that runs main(), named "main". It cannot be started or stopped: start() and stop() return true and
 * do nothing, and it is always running.
 */
class RTT_API MainThread : public ThreadInterface {
public:
    static ThreadInterface* Instance();
    /** Nothing is released, the main thread lives as long as the process. Kept for callers of the RTT API. */
    static void Release();

    bool start() override { return true; }
    bool stop() override { return true; }
    bool isRunning() const override { return true; }
    bool isActive() const override { return true; }
    bool setPeriod(Seconds) override { return false; }
    Seconds getPeriod() const override { return 0.0; }
    nsecs getPeriodNS() const override { return 0; }
    const char* getName() const override { return "main"; }
    RTOS_TASK* getTask() override { return &task_; }
    const RTOS_TASK* getTask() const override { return &task_; }
    unsigned int getPid() const override { return static_cast<unsigned>(task_.pid); }
    bool setScheduler(int scheduler) override;
    int getScheduler() const override;
    bool setPriority(int priority) override;
    int getPriority() const override;
    bool setCpuAffinity(unsigned cpuAffinity) override;
    unsigned getCpuAffinity() const override;
    void yield() override;
    void setMaxOverrun(int) override {}
    int getMaxOverrun() const override { return -1; }
    void setWaitPeriodPolicy(int) override {}
    void setStopTimeout(Seconds) override {}
    Seconds getStopTimeout() const override { return 0.0; }

private:
    MainThread();
    RTOS_TASK task_;
};

}  // namespace os
}  // namespace RTT
#endif
