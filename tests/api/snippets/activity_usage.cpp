// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Activities, threads, locks and time, as components use them.
#include <rtt/Activity.hpp>
#include <rtt/RTT.hpp>
#include <rtt/extras/PeriodicActivity.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/extras/SimulationActivity.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/os/Condition.hpp>
#include <rtt/os/Mutex.hpp>
#include <rtt/os/MutexLock.hpp>
#include <rtt/os/Semaphore.hpp>
#include <rtt/os/StartStopManager.hpp>
#include <rtt/os/TimeService.hpp>
#include <rtt/os/Timer.hpp>
#include <rtt/os/main.h>
#include <rtt/rt_string.hpp>

#include <gtest/gtest.h>

using namespace RTT;
using namespace RTT::os;

namespace {

class Counter : public TaskContext {
public:
    int updates;
    os::Semaphore updated;
    os::TimeService::ticks last;
    Seconds between;
    Counter(std::string name) : TaskContext(name), updates(0), updated(0), last(0), between(0.0) {}
    ~Counter() {
        stop();
        getActivity()->stop();
    }
    bool startHook() {
        last = os::TimeService::Instance()->getTicks();
        return true;
    }
    void updateHook() {
        between = os::TimeService::Instance()->secondsSince(last);
        last = os::TimeService::Instance()->getTicks();
        ++updates;
        updated.signal();
    }
};

int started = 0;
int startIt() { return ++started, 0; }

}  // namespace

TEST(UserCode, ChoosesAnActivity) {
    Counter counter("counter");
    EXPECT_TRUE(counter.setActivity(new Activity(ORO_SCHED_OTHER, os::LowestPriority, 0.002, 0, 0, "periodic")));
    EXPECT_EQ(counter.getPeriod(), 0.002);
    EXPECT_TRUE(counter.getActivity()->isPeriodic());
    EXPECT_TRUE(counter.start());
    counter.updated.wait();
    counter.updated.wait();
    EXPECT_GT(counter.between, 0.0);
    EXPECT_TRUE(counter.engine()->getActivity()->thread()->setPriority(0));
    EXPECT_STREQ(counter.getActivity()->thread()->getName(), "periodic");
    counter.getActivity()->thread()->setWaitPeriodPolicy(ORO_WAIT_REL);
    EXPECT_TRUE(counter.setPeriod(0.001));
    EXPECT_TRUE(counter.stop());
    EXPECT_FALSE(counter.trigger()) << "periodic";

    EXPECT_TRUE(counter.setActivity(new Activity(os::LowestPriority, 0.0, 0, "by hand")));
    EXPECT_FALSE(counter.getActivity()->isPeriodic());
    ASSERT_TRUE(counter.start());
    counter.updated.wait();
    EXPECT_TRUE(counter.trigger());
    counter.updated.wait();
    EXPECT_TRUE(counter.stop());

    EXPECT_TRUE(counter.setActivity(new extras::SequentialActivity()));
    counter.updates = 0;
    ASSERT_TRUE(counter.start());
    EXPECT_EQ(counter.updates, 1) << "in this thread";
    EXPECT_TRUE(counter.stop());
    EXPECT_TRUE(counter.setActivity(new extras::PeriodicActivity(ORO_SCHED_OTHER, 0, 0.001)));
    ASSERT_TRUE(counter.start());
    counter.updated.wait();
    EXPECT_TRUE(counter.stop());
    EXPECT_TRUE(counter.getActivity()->getCpuAffinity() != 0);
}

TEST(UserCode, MeasuresTime) {
    TimeService* time = TimeService::Instance();
    TimeService::ticks begin = time->getTicks();
    TimeService::nsecs ns = time->getNSecs();
    usleep(1000);
    TimeService::Seconds passed = time->secondsSince(begin);
    EXPECT_GE(passed, 0.001);
    EXPECT_GE(time->getNSecs(ns), 1000000);
    EXPECT_GT(time->getSeconds(), 0.0);
    EXPECT_GE(time->getSeconds(0.0), passed);
    EXPECT_GE(time->ticksSince(begin), 1000000);
    EXPECT_EQ(TimeService::ticks2nsecs(TimeService::nsecs2ticks(5000)), 5000);
    EXPECT_EQ(Seconds_to_nsecs(1.5), 1500000000);
    EXPECT_EQ(nsecs_to_Seconds(2500000000LL), 2.5);
    RTT::nsecs day = 86400000000000LL;
    RTT::msecs ms = 5;
    RTT::secs s = 1;
    EXPECT_EQ(day / 1000000000 + ms + s, 86406);
    TIME_SPEC spec = ticks2timespec(1500000000LL);
    EXPECT_EQ(spec.tv_sec, 1);
    EXPECT_EQ(spec.tv_nsec, 500000000);
}

TEST(UserCode, UsesLocks) {
    os::Mutex mutex;
    os::MutexRecursive recursive;
    {
        os::MutexLock lock(mutex);
        os::MutexTryLock second(mutex);
        EXPECT_FALSE(second.isSuccessful());
        os::MutexLock once(recursive);
        os::MutexTimedLock twice(recursive, 0.1);
        EXPECT_TRUE(twice.isSuccessful());
    }
    EXPECT_TRUE(mutex.trylock());
    mutex.unlock();
    mutex.lock();
    os::Condition condition;
    EXPECT_FALSE(condition.wait_until(mutex, os::TimeService::Instance()->getNSecs()));
    condition.broadcast();
    mutex.unlock();
    os::Semaphore semaphore(1);
    semaphore.wait();
    EXPECT_FALSE(semaphore.trywait());
    semaphore.signal();
    EXPECT_EQ(semaphore.value(), 1);
}

TEST(UserCode, KnowsSchedulersAndPriorities) {
    EXPECT_EQ(ORO_SCHED_RT, SCHED_FIFO);
    EXPECT_EQ(ORO_SCHED_OTHER, SCHED_OTHER);
    EXPECT_GT(os::HighestPriority, os::LowestPriority);
    EXPECT_EQ(os::HighestPriority - os::LowestPriority > 0, os::IncreasePriority > 0);
    int scheduler = ORO_SCHED_OTHER, priority = 0;
    EXPECT_TRUE(os::CheckPriority(scheduler, priority));
    os::StartStopManager::Instance()->startFunction(&startIt);
    os::StartStopManager::Instance()->start();
    EXPECT_EQ(started, 1);
    os::StartStopManager::Instance()->removeStartFunction(&startIt);
    EXPECT_EQ(__os_init(0, 0), 0);
}

TEST(UserCode, KeepsTextInRealTimeMemory) {
    RTT::rt_string text("a text that is longer than what fits into the object");
    text += rt_string(", and more");
    EXPECT_EQ(std::string(text.c_str()).size(), text.size());
    std::vector<int, os::rt_allocator<int>> numbers(3, 7);
    EXPECT_EQ(numbers.back(), 7);
    OutputPort<rt_string> out("out");
    InputPort<rt_string> in("in");
    ASSERT_TRUE(out.connectTo(&in));
    out.write(text);
    rt_string read;
    EXPECT_EQ(in.read(read), NewData);
    EXPECT_EQ(read, text);
}
