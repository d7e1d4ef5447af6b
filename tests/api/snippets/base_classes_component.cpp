// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The classes of components that users derive from, with what they override. `override` makes the compiler compare the
// signatures.
#include <rtt/TaskContext.hpp>
#include <rtt/Component.hpp>
#include <rtt/base/ExecutableInterface.hpp>
#include <rtt/base/RunnableInterface.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/os/Semaphore.hpp>
#include <rtt/os/Timer.hpp>
#include <rtt/plugin/ServicePlugin.hpp>

#include <gtest/gtest.h>

using namespace RTT;

namespace {

class Robot : public RTT::TaskContext {
public:
    std::string calls;
    Robot(const std::string& name) : TaskContext(name, PreOperational) {}
    ~Robot() { stop(); }

    bool configureHook() override { return note("configure "); }
    bool startHook() override { return note("start "); }
    void updateHook() override { note("update "); }
    bool breakUpdateHook() override { return true; }
    void errorHook() override { note("error "); }
    void stopHook() override { note("stop "); }
    void cleanupHook() override { note("cleanup "); }
    void exceptionHook() override { note("exception "); }
    bool dataOnPortHook(RTT::base::PortInterface*) override { return true; }

    // The public part may be overridden as well.
    bool configure() override { return TaskContext::configure(); }
    bool start() override { return TaskContext::start(); }
    bool stop() override { return TaskContext::stop(); }
    bool activate() override { return TaskContext::activate(); }
    bool cleanup() override { return TaskContext::cleanup(); }
    bool recover() override { return TaskContext::recover(); }
    void error() override { TaskContext::error(); }
    bool update() override { return TaskContext::update(); }
    bool trigger() override { return TaskContext::trigger(); }
    bool isRunning() const override { return TaskContext::isRunning(); }
    bool isConfigured() const override { return TaskContext::isConfigured(); }
    bool isActive() const override { return TaskContext::isActive(); }
    bool inFatalError() const override { return TaskContext::inFatalError(); }
    bool inException() const override { return TaskContext::inException(); }
    bool inRunTimeError() const override { return TaskContext::inRunTimeError(); }
    TaskState getTaskState() const override { return TaskContext::getTaskState(); }
    TaskState getTargetState() const override { return TaskContext::getTargetState(); }
    Seconds getPeriod() const override { return TaskContext::getPeriod(); }
    bool setPeriod(Seconds s) override { return TaskContext::setPeriod(s); }
    unsigned getCpuAffinity() const override { return TaskContext::getCpuAffinity(); }
    bool setCpuAffinity(unsigned cpu) override { return TaskContext::setCpuAffinity(cpu); }
    bool ready() override { return TaskContext::ready(); }
    void clear() override { TaskContext::clear(); }
    bool addPeer(TaskContext* peer, std::string alias = "") override { return TaskContext::addPeer(peer, alias); }
    void removePeer(const std::string& name) override { TaskContext::removePeer(name); }
    void removePeer(TaskContext* peer) override { TaskContext::removePeer(peer); }
    bool connectPeers(TaskContext* peer) override { return TaskContext::connectPeers(peer); }
    void disconnectPeers(const std::string& name) override { TaskContext::disconnectPeers(name); }
    void disconnect() override { TaskContext::disconnect(); }
    PeerList getPeerList() const override { return TaskContext::getPeerList(); }
    bool hasPeer(const std::string& name) const override { return TaskContext::hasPeer(name); }
    TaskContext* getPeer(const std::string& name) const override { return TaskContext::getPeer(name); }
    bool connectPorts(TaskContext* peer) override { return TaskContext::connectPorts(peer); }
    bool connectServices(TaskContext* peer) override { return TaskContext::connectServices(peer); }

protected:
    void exception() override { TaskContext::exception(); }
    void fatal() override { TaskContext::fatal(); }

private:
    bool note(const char* what) {
        calls += what;
        return true;
    }
};

class Gripper : public RTT::Service {
public:
    double width;
    Gripper(RTT::TaskContext* owner) : Service("gripper", owner), width(0.0) {
        doc("Opens and closes.");
        addOperation("open", &Gripper::open, this, OwnThread).doc("Opens it.").arg("width", "in m");
        addOperation("width", &Gripper::getWidth, this);
        addProperty("speed", speed).doc("in m/s");
        addPort("state", state);
    }
    bool addService(Service::shared_ptr sub) override { return Service::addService(sub); }
    void removeService(const std::string& name) override { Service::removeService(name); }
    void clear() override { Service::clear(); }
    bool open(double w) {
        width = w;
        return getOwner() != 0;
    }
    double getWidth() const { return width; }

private:
    double speed = 0.1;
    OutputPort<double> state;
};

class GripperUser : public RTT::ServiceRequester {
public:
    typedef boost::shared_ptr<GripperUser> shared_ptr;
    GripperUser(RTT::TaskContext* owner = 0) : ServiceRequester("gripper", owner), open("open"), width("width") {
        addOperationCaller(open);
        addOperationCaller(width);
    }
    bool connectTo(Service::shared_ptr service) override { return ServiceRequester::connectTo(service); }
    OperationCaller<bool(double)> open;
    OperationCaller<double(void)> width;
};

/** Executed by the engine until it has counted to three. */
struct Countdown : public RTT::base::ExecutableInterface {
    int left = 3;
    os::Semaphore done{0};
    bool execute() override {
        if (--left == 0) done.signal();
        return left > 0;
    }
    void loaded(ExecutionEngine* e) override { base::ExecutableInterface::loaded(e); }
    void unloaded() override { base::ExecutableInterface::unloaded(); }
};

class Watchdog : public RTT::os::Timer {
public:
    os::Semaphore expired{0};
    int last = -1;
    Watchdog() : Timer(2, ORO_SCHED_OTHER, 0) {}
    ~Watchdog() { stopThread(); }
    void timeout(Timer::TimerId id) override {
        last = id;
        expired.signal();
    }
};

}  // namespace

TEST(UserCode, DerivesAComponent) {
    Robot robot("robot");
    robot.setActivity(new extras::SlaveActivity());
    EXPECT_TRUE(robot.configure() && robot.start() && robot.update() && robot.stop() && robot.cleanup());
    EXPECT_EQ(robot.calls, "configure start update stop cleanup ");
}

TEST(UserCode, DerivesAServiceAndItsRequester) {
    Robot robot("robot");
    ASSERT_TRUE(robot.provides()->addService(Service::shared_ptr(new Gripper(&robot))));
    Robot client("client");
    client.connectPeers(&robot);
    GripperUser::shared_ptr user = robot.getProvider<GripperUser>("gripper");
    ASSERT_TRUE(user && user->ready());
    EXPECT_TRUE(user->open(0.04));
    EXPECT_EQ(user->width(), 0.04);
    boost::shared_ptr<Gripper> same = robot.getProvider<Gripper>("gripper");
    ASSERT_TRUE(same);
    EXPECT_EQ(same->width, 0.04);
    EXPECT_EQ(robot.provides("gripper")->getProperty("speed")->getDescription(), "in m/s");
}

TEST(UserCode, DerivesAFunctionOfTheEngine) {
    Robot robot("robot");
    robot.setActivity(new Activity(ORO_SCHED_OTHER, 0, 0.001, 0, "robot"));
    Countdown countdown;
    ASSERT_TRUE(robot.configure() && robot.start());
    ASSERT_TRUE(robot.engine()->runFunction(&countdown));
    countdown.done.wait();
    EXPECT_TRUE(robot.engine()->removeFunction(&countdown));
    EXPECT_TRUE(robot.engine()->removeSelfFunction(&countdown)) << "it is not loaded";
    EXPECT_FALSE(countdown.isLoaded());
    EXPECT_EQ(countdown.left, 0);
}

TEST(UserCode, DerivesATimer) {
    Watchdog watchdog;
    ASSERT_TRUE(watchdog.arm(1, 0.001));
    watchdog.expired.wait();
    EXPECT_EQ(watchdog.last, 1);
    EXPECT_TRUE(watchdog.startTimer(0, 0.001));
    watchdog.expired.wait();
    EXPECT_TRUE(watchdog.killTimer(0));
    EXPECT_FALSE(watchdog.isArmed(0));
}
