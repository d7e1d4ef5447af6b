// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_THREAD_INTERFACE_HPP
#define ORO_OS_THREAD_INTERFACE_HPP

#include <rtt/Time.hpp>
#include <rtt/os/fosi.h>

namespace RTT {
namespace os {

/** A thread of the operating system. Its functions may be called from any thread. */
class RTT_API ThreadInterface {
public:
    ThreadInterface() = default;
    virtual ~ThreadInterface();
    ThreadInterface(const ThreadInterface&) = delete;
    ThreadInterface& operator=(const ThreadInterface&) = delete;

    virtual bool start() = 0;
    virtual bool stop() = 0;
    /** True while the thread executes user code, or, if periodic, may execute it. */
    virtual bool isRunning() const = 0;
    /** True from a successful start() to stop(). */
    virtual bool isActive() const = 0;

    virtual bool setPeriod(Seconds period) = 0;
    virtual Seconds getPeriod() const = 0;
    virtual nsecs getPeriodNS() const = 0;
    virtual bool isPeriodic() const { return getPeriodNS() != 0; }

    virtual const char* getName() const = 0;
    virtual RTOS_TASK* getTask() = 0;
    virtual const RTOS_TASK* getTask() const = 0;
    /** Linux thread id. */
    virtual unsigned int getPid() const = 0;

    /** False if the scheduler is unknown or refused; the old one stays. */
    virtual bool setScheduler(int scheduler) = 0;
    virtual int getScheduler() const = 0;
    virtual bool setPriority(int priority) = 0;
    virtual int getPriority() const = 0;
    /** Bit n allows CPU n; 0 allows every CPU with which the process started. */
    virtual bool setCpuAffinity(unsigned cpuAffinity) = 0;
    virtual unsigned getCpuAffinity() const = 0;

    virtual void yield() = 0;
    virtual void setMaxOverrun(int maxOverrun) = 0;
    virtual int getMaxOverrun() const = 0;
    /** ORO_WAIT_ABS or ORO_WAIT_REL. */
    virtual void setWaitPeriodPolicy(int policy) = 0;
    /** Seconds that stop() waits for the thread; 0 selects the default. */
    virtual void setStopTimeout(Seconds timeout) = 0;
    virtual Seconds getStopTimeout() const = 0;

    /** True if the caller is this thread. Real-time safe. */
    virtual bool isSelf() const;
    /** The number of this thread in os::threads; −1 if it has none. */
    int threadNumber() const { return number_; }

protected:
    /** Adds the thread to os::threads. */
    void enlist(const char* name, unsigned pid);
    void delist();

private:
    int number_ = -1;
};

}  // namespace os
}  // namespace RTT
#endif
