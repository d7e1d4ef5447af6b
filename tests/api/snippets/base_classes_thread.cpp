// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Threads and activities that users write.
#include <rtt/Activity.hpp>
#include <rtt/base/ActionInterface.hpp>
#include <rtt/base/ActivityInterface.hpp>
#include <rtt/base/RunnableInterface.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/os/MutexLock.hpp>
#include <rtt/os/Semaphore.hpp>
#include <rtt/os/Thread.hpp>

#include <boost/scoped_ptr.hpp>

#include <gtest/gtest.h>

using namespace RTT;

namespace {

/** An activity that polls a device in its loop, and leaves it when asked to. */
class Poller : public RTT::Activity {
public:
    int initialized = 0, finalized = 0;
    os::Semaphore inLoop{0};
    Poller() : Activity(ORO_SCHED_OTHER, 0, 0.0, 0, "poller"), go(true) {}
    ~Poller() { stop(); }
    bool start() override { return Activity::start(); }
    bool stop() override { return Activity::stop(); }
    bool isRunning() const override { return Activity::isRunning(); }
    bool isActive() const override { return Activity::isActive(); }
    bool isPeriodic() const override { return Activity::isPeriodic(); }
    Seconds getPeriod() const override { return Activity::getPeriod(); }
    bool setPeriod(Seconds s) override { return Activity::setPeriod(s); }
    bool execute() override { return Activity::execute(); }
    bool trigger() override { return Activity::trigger(); }
    bool timeout() override { return Activity::timeout(); }
    bool run(base::RunnableInterface* r) override { return Activity::run(r); }
    os::ThreadInterface* thread() override { return Activity::thread(); }
    bool initialize() override {
        ++initialized;
        return true;
    }
    void step() override {}
    void loop() override {
        inLoop.signal();
        while (go) usleep(100);
    }
    bool breakLoop() override {
        go = false;
        return true;
    }
    void finalize() override { ++finalized; }

private:
    std::atomic<bool> go;
};

class Worker : public RTT::os::Thread {
public:
    int steps = 0;
    os::Semaphore stepped{0};
    Worker() : Thread(ORO_SCHED_OTHER, 0, 0.001, 0, "worker") {}
    ~Worker() {
        stop();
        terminate();
    }
    bool initialize() override { return true; }
    void step() override {
        ++steps;
        stepped.signal();
    }
    void loop() override {}
    bool breakLoop() override { return true; }
    void finalize() override {}
};

class Runner : public RTT::base::RunnableInterface {
public:
    int steps = 0, works = 0;
    bool initialize() override { return true; }
    void step() override { ++steps; }
    void loop() override {}
    bool breakLoop() override { return false; }
    void finalize() override {}
    bool hasWork() override { return false; }
    void work(RunnableInterface::WorkReason reason) override { works += reason == RunnableInterface::TimeOut; }
};

/** Executes its runner when somebody else's callback comes. */
class CallbackActivity : public RTT::base::ActivityInterface {
public:
    CallbackActivity(base::RunnableInterface* r = 0) : ActivityInterface(r), active(false) {}
    ~CallbackActivity() override { stop(); }
    bool start() override {
        if (active || (runner && !runner->initialize())) return false;
        return active = true;
    }
    bool stop() override {
        if (!active) return false;
        active = false;
        if (runner) runner->finalize();
        return true;
    }
    bool isRunning() const override { return active; }
    bool isActive() const override { return active; }
    Seconds getPeriod() const override { return 0.5; }
    bool setPeriod(Seconds) override { return false; }
    bool isPeriodic() const override { return true; }
    unsigned getCpuAffinity() const override { return ~0u; }
    bool setCpuAffinity(unsigned) override { return false; }
    bool execute() override {
        if (!active) return false;
        runner->step();
        runner->work(base::RunnableInterface::TimeOut);
        return true;
    }
    bool trigger() override { return false; }
    bool timeout() override { return false; }
    os::ThreadInterface* thread() override { return 0; }

private:
    bool active;
};

class Add : public RTT::base::ActionInterface {
public:
    Add(int& to, int what) : to_(to), what_(what) {}
    void readArguments() override {}
    bool execute() override {
        to_ += what_;
        return true;
    }
    void reset() override {}
    bool valid() const override { return true; }
    base::ActionInterface* clone() const override { return new Add(to_, what_); }
    base::ActionInterface* copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>&) const override {
        return clone();
    }

private:
    int& to_;
    int what_;
};

class NamedLock : public RTT::os::MutexLock {
public:
    NamedLock(os::Mutex& mutex, const char* name) : MutexLock(mutex), name(name) {}
    const char* name;
};

}  // namespace

TEST(UserCode, DerivesAnActivity) {
    Poller poller;
    ASSERT_TRUE(poller.start());
    poller.inLoop.wait();
    EXPECT_TRUE(poller.isRunning());
    EXPECT_TRUE(poller.stop());
    EXPECT_FALSE(poller.isActive());
    EXPECT_EQ(poller.initialized, 1);
    EXPECT_EQ(poller.finalized, 1);
}

TEST(UserCode, DerivesAThread) {
    Worker worker;
    ASSERT_TRUE(worker.start());
    worker.stepped.wait();
    worker.stepped.wait();
    EXPECT_TRUE(worker.stop());
    EXPECT_GE(worker.steps, 2);
}

TEST(UserCode, DerivesARunnableAndAnActivityForIt) {
    Runner runner;
    CallbackActivity activity(&runner);
    EXPECT_EQ(runner.getActivity(), &activity);
    EXPECT_TRUE(activity.start() && activity.execute() && activity.stop());
    EXPECT_TRUE(activity.run(0));
    EXPECT_EQ(activity.getRunner(), static_cast<base::RunnableInterface*>(0));
    EXPECT_TRUE(activity.run(&runner));
    EXPECT_EQ(runner.steps, 1);
    EXPECT_EQ(runner.works, 1);
}

TEST(UserCode, DerivesAnAction) {
    int sum = 1;
    boost::scoped_ptr<base::ActionInterface> action(new Add(sum, 2));
    boost::scoped_ptr<base::ActionInterface> copy(action->clone());
    EXPECT_TRUE(action->execute() && copy->execute());
    EXPECT_EQ(sum, 5);
}

TEST(UserCode, DerivesALock) {
    os::Mutex mutex;
    {
        NamedLock lock(mutex, "mine");
        EXPECT_STREQ(lock.name, "mine");
    }
    EXPECT_TRUE(mutex.trylock());
    mutex.unlock();
}
