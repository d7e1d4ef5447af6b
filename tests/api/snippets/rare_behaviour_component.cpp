// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What few packages do with components, and then rely on.
#include <rtt/RTT.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/internal/GlobalService.hpp>
#include <rtt/internal/Signal.hpp>
#include <rtt/os/Semaphore.hpp>
#include <rtt/os/startstop.h>

#include <boost/lexical_cast.hpp>

#include <gtest/gtest.h>

using namespace RTT;

namespace {

class Master : public RTT::TaskContext {
public:
    Master() : TaskContext("master"), updates(0) { setActivity(new extras::SlaveActivity(0.01)); }
    void updateHook() {
        ++updates;
        TaskContext::PeerList peers = this->getPeerList();
        for (TaskContext::PeerList::iterator it = peers.begin(); it != peers.end(); ++it) {
            if (getPeer(*it)->getActivity<extras::SlaveActivity>()) getPeer(*it)->update();
        }
    }
    int updates;
};

class Slave : public RTT::TaskContext {
public:
    Slave(std::string name) : TaskContext(name), updates(0) {}
    void updateHook() { ++updates; }
    int updates;
};

/** Everything of it comes while it is configured. */
class Dynamic : public RTT::TaskContext {
public:
    typedef std::vector<boost::shared_ptr<InputPort<std::vector<double>>>> Inputs;
    Inputs inputs;
    std::vector<OutputPort<double>*> outputs;
    std::vector<double> gains;
    int count;
    bool events;
    int called;

    Dynamic(std::string const& name) : TaskContext(name, PreOperational), count(2), events(true), called(0) {
        this->addProperty("count", count).doc("number of ports");
        this->addProperty("events", events);
    }
    ~Dynamic() { forget(); }
    bool configureHook() {
        forget();
        gains.assign(count, 1.0);
        for (int i = 0; i < count; ++i) {
            char name[32];
            snprintf(name, sizeof(name), "joint-%d", i);
            boost::shared_ptr<InputPort<std::vector<double>>> port(new InputPort<std::vector<double>>(name));
            inputs.push_back(port);
            if (events)
                this->ports()->addEventPort(*port, boost::bind(&Dynamic::onData, this, _1));
            else
                this->ports()->addPort(*port);
            snprintf(name, sizeof(name), "tx-servo%d", i);
            outputs.push_back(new OutputPort<double>(name));
            this->addPort(*outputs.back()).doc("to the servo");
            snprintf(name, sizeof(name), "gain%d", i);
            this->addProperty(name, gains[i]);
            snprintf(name, sizeof(name), "reset%d", i);
            this->addOperation(name, &Dynamic::reset, this, OwnThread).doc("Resets.").arg("to", "the value");
        }
        // Its own activity, in the middle of configure().
        return this->setActivity(new Activity(ORO_SCHED_OTHER, 0, 0.0, 0, 0, getName()));
    }
    void cleanupHook() { forget(); }
    void forget() {
        for (size_t i = 0; i < inputs.size(); ++i) {
            this->ports()->removePort(inputs[i]->getName());
            this->ports()->removePort(outputs[i]->getName());
            delete outputs[i];
            this->provides()->removeProperty(*this->properties()->find("gain" + boost::lexical_cast<std::string>(i)));
            this->provides()->removeOperation("reset" + boost::lexical_cast<std::string>(i));
        }
        inputs.clear();
        outputs.clear();
    }
    void onData(RTT::base::PortInterface* port) {
        std::vector<double> sample;
        if (dynamic_cast<RTT::base::InputPortInterface*>(port) &&
            static_cast<InputPort<std::vector<double>>*>(port)->read(sample) == NewData)
            called += int(sample.size());
    }
    double reset(double to) { return to * 2; }
};

class Loop : public RTT::TaskContext {
public:
    Loop() : TaskContext("rt-loop", PreOperational), updates(0), updated(0) {
        addOperation("throw", &Loop::fling, this, OwnThread);
        addOperation("inThread", &Loop::inThread, this, OwnThread);
    }
    ~Loop() {
        stop();
        getActivity()->stop();
    }
    void updateHook() {
        ++updates;
        updated.signal();
    }
    bool inThread() { return getActivity()->thread()->isSelf(); }
    void fling() { throw std::runtime_error("flung"); }
    int updates;
    os::Semaphore updated;
};

double scale(double x) { return 3 * x; }

}  // namespace

TEST(UserCode, UpdatesThePeersOfAMaster) {
    Master master;
    Slave left("left"), right("right"), other("other");
    left.setActivity(new extras::SlaveActivity(master.getActivity(), left.engine()));
    right.setActivity(new extras::SlaveActivity(master.getActivity(), right.engine()));
    master.addPeer(&left);
    master.addPeer(&right);
    master.addPeer(&other);
    ASSERT_TRUE(master.start());
    ASSERT_TRUE(left.start());
    ASSERT_TRUE(right.start());
    const int before = master.updates, leftBefore = left.updates, rightBefore = right.updates;
    EXPECT_TRUE(master.update());
    EXPECT_EQ(master.updates, before + 1);
    EXPECT_EQ(left.updates, leftBefore + 1);
    EXPECT_EQ(right.updates, rightBefore + 1);
    EXPECT_EQ(other.updates, 0);
}

TEST(UserCode, MakesItsInterfaceWhileItIsConfigured) {
    Dynamic component("dynamic-1");
    for (int round = 0; round < 2; ++round) {
        ASSERT_TRUE(component.configure());
        EXPECT_EQ(component.ports()->getPorts().size(), 4u);
        ASSERT_TRUE(component.getPort("tx-servo1"));
        EXPECT_EQ(component.getPort("tx-servo1")->getDescription(), "to the servo");
        ASSERT_TRUE(component.getProperty("gain1"));
        OperationCaller<double(double)> reset(component.getOperation("reset0"), internal::GlobalEngine::Instance());
        EXPECT_EQ(reset(2.0), 4.0);
        OutputPort<std::vector<double>> out("out");
        ASSERT_TRUE(out.connectTo(component.getPort("joint-0")));
        ASSERT_TRUE(component.start());
        out.write(std::vector<double>(6));
        EXPECT_EQ(reset(1.0), 2.0) << "is executed after the callback";
        EXPECT_EQ(component.called, 6 * (round + 1));
        ASSERT_TRUE(component.stop());
        ASSERT_TRUE(component.cleanup());
        EXPECT_TRUE(component.ports()->getPorts().empty());
        EXPECT_EQ(component.getProperty("gain1"), static_cast<base::PropertyBase*>(0));
        EXPECT_FALSE(component.provides()->hasOperation("reset0"));
    }
}

TEST(UserCode, CallsAComponentThatIsNotConfigured) {
    Loop loop;
    OperationCaller<bool(void)> inThread(loop.getOperation("inThread"), internal::GlobalEngine::Instance());
    EXPECT_TRUE(inThread());
    ASSERT_TRUE(loop.configure());
    EXPECT_TRUE(inThread());
    EXPECT_EQ(loop.updates, 0);
    ASSERT_TRUE(loop.start());
    loop.updated.wait();
    EXPECT_TRUE(inThread());
    EXPECT_EQ(loop.updates, 1) << "start() makes one";
}

TEST(UserCode, CallsAnOperationNamedThrow) {
    Loop loop;
    TaskContext client("client");
    OperationCaller<void(void)> fling(loop.getOperation("throw"), client.engine());
    ASSERT_TRUE(fling.ready());
    EXPECT_THROW(fling(), std::runtime_error);
    EXPECT_TRUE(loop.inException());
    EXPECT_TRUE(loop.recover());
}

TEST(UserCode, EmitsASignal) {
    RTT::internal::Signal<void(double)> event;
    double sum = 0.0;
    struct Listener {
        double& sum;
        void add(double x) { sum += x; }
    } listener = {sum};
    RTT::Handle handle = event.connect(boost::bind(&Listener::add, &listener, _1));
    EXPECT_TRUE(handle.connected());
    event(1.5);
    EXPECT_TRUE(handle.disconnect());
    event.emit(2.0);
    EXPECT_FALSE(handle.connected());
    EXPECT_TRUE(handle.connect());
    event(1.0);
    EXPECT_EQ(sum, 2.5);
}

TEST(UserCode, OffersAGlobalService) {
    RTT::Service::shared_ptr rosService = RTT::internal::GlobalService::Instance()->provides("snippets");
    rosService->doc("for everybody");
    rosService->addOperation("scale", &scale).doc("Scales.").arg("x", "what");
    OperationCaller<double(double)> call =
        RTT::internal::GlobalService::Instance()->getService("snippets")->getOperation("scale");
    EXPECT_EQ(call(2.0), 6.0);
    RTT::internal::GlobalService::Instance()->removeService("snippets");
    EXPECT_FALSE(RTT::internal::GlobalService::Instance()->hasService("snippets"));
}

TEST(UserCode, ReadsTheArgumentsOfTheProgram) {
    char name[] = "program", option[] = "-x";
    char* argv[] = {name, option, 0};
    ASSERT_EQ(__os_init(2, argv), 0);
    EXPECT_EQ(__os_main_argc(), 2);
    EXPECT_STREQ(__os_main_argv()[1], "-x");
}
