// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_SCHEDULE_SCHEDULED_THREAD_HPP
#define OROFORGE_SCHEDULE_SCHEDULED_THREAD_HPP

#include <rtt/os/MainThread.hpp>

#include <atomic>
#include <string>

namespace OCL::schedule {

class ScheduledActivity;

/** What a component finds as the thread of its activity: numbers that it can read and set, which the thread of the
    schedule does not have. */
class ScheduledThread final : public RTT::os::ThreadInterface {
public:
    ScheduledThread(std::string name, int scheduler, int priority, ScheduledActivity& activity);

    bool start() override;
    bool stop() override;
    bool isRunning() const override;
    bool isActive() const override;
    bool setPeriod(RTT::Seconds period) override;
    RTT::Seconds getPeriod() const override;
    RTT::nsecs getPeriodNS() const override;
    const char* getName() const override { return name_.c_str(); }
    RTOS_TASK* getTask() override { return RTT::os::MainThread::Instance()->getTask(); }
    const RTOS_TASK* getTask() const override { return RTT::os::MainThread::Instance()->getTask(); }
    unsigned int getPid() const override { return RTT::os::MainThread::Instance()->getPid(); }
    bool setScheduler(int scheduler) override;
    int getScheduler() const override { return scheduler_; }
    bool setPriority(int priority) override;
    int getPriority() const override { return priority_; }
    bool setCpuAffinity(unsigned cpus) override;
    unsigned getCpuAffinity() const override { return cpus_; }
    void yield() override {}
    void setMaxOverrun(int overruns) override { overruns_ = overruns; }
    int getMaxOverrun() const override { return overruns_; }
    void setWaitPeriodPolicy(int) override {}
    void setStopTimeout(RTT::Seconds timeout) override { stopTimeout_ = timeout; }
    RTT::Seconds getStopTimeout() const override { return stopTimeout_; }
    bool isSelf() const override;

private:
    const std::string name_;
    ScheduledActivity& activity_;
    std::atomic<int> scheduler_, priority_, overruns_{-1};
    std::atomic<unsigned> cpus_{0};
    std::atomic<double> stopTimeout_{0};
};

}  // namespace OCL::schedule

#endif
