// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Ports as part of a component: names, services, and waking the component by new samples.
#include "log_capture.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/Port.hpp>
#include <rtt/Service.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/extras/SequentialActivity.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

using namespace RTT;

namespace {

template <class Condition>
bool soon(Condition condition) {
    for (int i = 0; i < 4000 && !condition(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return condition();
}

struct Component : TaskContext {
    explicit Component(const std::string& name = "component") : TaskContext(name) {
        addPort(out).doc("what comes out");
        addEventPort(in, [this](base::PortInterface* port) {
            EXPECT_EQ(port, &in);
            int got = 0;
            if (in.read(got) == NewData) sum += got;
            ++calls;
        });
        addEventPort(wake);
    }
    ~Component() override { stop(); }
    void updateHook() override { ++updates; }

    OutputPort<int> out{"out"};
    InputPort<int> in{"in"}, wake{"wake"};
    std::atomic<int> calls{0}, sum{0}, updates{0};
};

}  // namespace

TEST(ComponentPorts, KnowTheirComponent) {
    Component c;
    EXPECT_EQ(c.in.getFullName(), "component.in");
    EXPECT_EQ(c.in.getInterface()->getOwner(), &c);
    EXPECT_EQ(c.ports()->getPortNames(), (std::vector<std::string>{"out", "in", "wake"}));
    EXPECT_EQ(c.ports()->getPort("in"), &c.in);
    EXPECT_EQ(c.ports()->getPort("none"), nullptr);
    EXPECT_EQ(c.ports()->getPortType<OutputPort<int>>("out"), &c.out);
    EXPECT_EQ(c.ports()->getPortType<OutputPort<int>>("in"), nullptr);
    EXPECT_EQ(c.ports()->getPortDescription("out"), "what comes out");
}

TEST(ComponentPorts, HaveAServiceWithOperations) {
    Component c, peer("peer");
    c.out.connectTo(&peer.in);
    ASSERT_TRUE(c.provides()->hasService("out"));
    EXPECT_EQ(c.provides("out")->doc(), "what comes out");
    EXPECT_EQ(c.provides("in")->doc(), "No description set for this Port. Use .doc() to document it.");
    OperationCaller<WriteStatus(const int&)> write = c.provides("out")->getOperation("write");
    OperationCaller<int()> last = c.provides("out")->getOperation("last");
    OperationCaller<FlowStatus(int&)> read = peer.provides("in")->getOperation("read");
    OperationCaller<bool()> connected = peer.provides("in")->getOperation("connected");
    OperationCaller<std::string()> name = peer.provides("in")->getOperation("name");
    OperationCaller<void()> clear = peer.provides("in")->getOperation("clear");
    OperationCaller<void()> disconnect = peer.provides("in")->getOperation("disconnect");
    ASSERT_TRUE(write.ready() && last.ready() && read.ready() && connected.ready() && name.ready() && clear.ready() &&
                disconnect.ready());
    int got = 0;
    EXPECT_EQ(write(5), WriteSuccess);
    EXPECT_EQ(last(), 5);
    EXPECT_EQ(read(got), NewData);
    EXPECT_EQ(got, 5);
    clear();
    EXPECT_EQ(read(got), NoData);
    EXPECT_EQ(name(), "in");
    EXPECT_TRUE(connected());
    disconnect();
    EXPECT_FALSE(c.out.connected());
}

TEST(ComponentPorts, ServicesThatOutliveThePortHaveNoOperations) {
    Service::shared_ptr looked, late;
    {
        Component c;
        looked = c.provides("in");
        late = c.provides("out");
        EXPECT_EQ(looked->getOperationNames(),
                  (std::vector<std::string>{"clear", "connected", "disconnect", "name", "read"}));
    }
    EXPECT_TRUE(looked->hasOperation("read"));
    OperationCaller<FlowStatus(int&)> read = looked->getOperation("read");
    int sample = 0;
    EXPECT_EQ(read(sample), NoData);
    EXPECT_EQ(late->getOperationNames(), std::vector<std::string>());
    EXPECT_EQ(late->getOperation("write"), nullptr);
}

TEST(ComponentPorts, ServicesTakeOperationsOfTheComponent) {
    Component c;
    c.provides("in")->addOperation("twice", [](int x) { return 2 * x; });
    OperationCaller<int(int)> twice = c.provides("in")->getOperation("twice");
    EXPECT_EQ(twice(4), 8);
    EXPECT_TRUE(c.provides("in")->hasOperation("read"));
    c.provides("in")->addOperation("connected", [] { return true; });
    OperationCaller<bool()> connected = c.provides("in")->getOperation("connected");
    EXPECT_TRUE(connected());
    c.provides("in")->removeOperation("name");
    EXPECT_FALSE(c.provides("in")->hasOperation("name"));
    EXPECT_TRUE(c.provides("in")->hasOperation("clear"));
}

TEST(ComponentPorts, DescribeTheirServiceWhenTheyAreDescribedLater) {
    Component c;
    c.in.doc("what goes in");
    EXPECT_EQ(c.provides("in")->doc(), "what goes in");
}

TEST(ComponentPorts, AreReplacedByAPortOfTheSameName) {
    flow_test::LogCapture log;
    Component c, peer("peer");
    peer.out.connectTo(&c.in);
    InputPort<double> other("in");
    c.addPort(other);
    EXPECT_TRUE(log.contains("port name 'in' is in use already")) << log.text();
    EXPECT_FALSE(c.in.connected());
    EXPECT_EQ(c.in.getInterface(), nullptr);
    EXPECT_EQ(c.ports()->getPort("in"), &other);
}

TEST(ComponentPorts, ComeAndGoAtRunTime) {
    Component c;
    {
        InputPort<double> temporary("temporary");
        c.addPort(temporary);
        EXPECT_TRUE(c.provides()->hasService("temporary"));
    }
    EXPECT_EQ(c.ports()->getPort("temporary"), nullptr);
    EXPECT_FALSE(c.provides()->hasService("temporary"));
    c.ports()->removePort("in");
    EXPECT_FALSE(c.provides()->hasService("in"));
    c.ports()->removePort("none");
}

TEST(EventPort, CallsBackOncePerSample) {
    Component c, peer("peer");
    peer.out.createConnection(c.in, ConnPolicy::buffer(20));
    ASSERT_TRUE(c.start());
    for (int i = 1; i <= 10; ++i) {
        peer.out.write(1);
        ASSERT_TRUE(soon([&] { return c.calls == i; })) << i << " samples, " << c.calls << " calls";
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_EQ(c.calls, 10);
    EXPECT_EQ(c.sum, 10);
}

TEST(EventPort, WithoutCallbackTriggersTheComponent) {
    Component c, peer("peer");
    peer.out.connectTo(&c.wake);
    ASSERT_TRUE(c.start());
    ASSERT_TRUE(soon([&] { return c.updates >= 1; }));  // start() of a non-periodic component
    const int before = c.updates;
    peer.out.write(1);
    EXPECT_TRUE(soon([&] { return c.updates == before + 1; }));
    EXPECT_EQ(c.calls, 0);
}

TEST(EventPort, KeepsDataButNotTheSignalOfASampleWrittenBeforeStart) {
    Component c, peer("peer");
    peer.out.connectTo(&c.in);
    peer.out.write(3);
    ASSERT_TRUE(c.start());
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_EQ(c.calls, 0);
    int got = 0;
    EXPECT_EQ(c.in.read(got), NewData);
    EXPECT_EQ(got, 3);
}

TEST(EventPort, IsSignalledByInitOfANewConnection) {
    Component c, peer("peer");
    peer.out.write(3);
    ASSERT_TRUE(c.start());
    peer.out.createConnection(c.in, ConnPolicy::data());
    EXPECT_TRUE(soon([&] { return c.calls == 1; }));
    EXPECT_EQ(c.sum, 3);
}

TEST(EventPort, IsNotSignalledByADataSample) {
    Component c, peer("peer");
    peer.out.connectTo(&c.in);
    ASSERT_TRUE(c.start());
    peer.out.setDataSample(5);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_EQ(c.calls, 0);
    peer.out.write(1);
    EXPECT_TRUE(soon([&] { return c.calls == 1; }));
    EXPECT_EQ(c.sum, 1);
}

TEST(EventPort, IsNotSignalledForADroppedSample) {
    Component c, peer("peer");
    peer.out.createConnection(c.in, ConnPolicy::buffer(0));
    ASSERT_TRUE(c.start());
    EXPECT_EQ(peer.out.write(1), WriteFailure);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_EQ(c.calls, 0);
}

TEST(EventPort, MayRunItsComponentInTheWritersThreadWhichMayDisconnectThePort) {
    struct Sequential : Component {
        void updateHook() override {
            Component::updateHook();
            wake.disconnect();
            out.write(updates);
        }
    } c;
    Component peer("peer");
    c.setActivity(new extras::SequentialActivity());
    peer.out.connectTo(&c.wake);
    c.out.createConnection(peer.wake, ConnPolicy::buffer(5));
    ASSERT_TRUE(c.start());
    const int before = c.updates;
    if (!c.wake.connected()) peer.out.connectTo(&c.wake);
    peer.out.write(1);
    EXPECT_TRUE(soon([&] { return c.updates > before; }));
    EXPECT_FALSE(c.wake.connected());
}

TEST(EventPort, DropsTheCallbackOfASampleThatStopOvertook) {
    struct Stopping : Component {
        using Component::Component;
        bool dataOnPortHook(base::PortInterface* port) override {
            const bool wanted = Component::dataOnPortHook(port);
            stop();
            return wanted;
        }
    } c;
    Component peer("peer");
    peer.out.connectTo(&c.in);
    ASSERT_TRUE(c.start());
    peer.out.write(1);
    EXPECT_FALSE(c.isRunning());
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_EQ(c.calls, 0);
}

TEST(EventPort, CallsBackAComponentThatIsNotRunningIfItsHookWantsThat) {
    struct Always : Component {
        bool dataOnPortHook(base::PortInterface*) override { return true; }
    } c;
    Component peer("peer");
    peer.out.connectTo(&c.in);
    peer.out.write(1);
    EXPECT_TRUE(soon([&] { return c.calls == 1; }));
}

TEST(EventPort, IsDestroyedSafelyWhileItIsWrittenTo) {
    OutputPort<int> out("out");
    struct Writer {
        explicit Writer(OutputPort<int>& port)
            : thread([this, &port] {
                  for (int i = 0; !stop; ++i) port.write(i);
              }) {}
        ~Writer() {
            stop = true;
            thread.join();
        }
        std::atomic<bool> stop{false};
        std::thread thread;
    } writer(out);
    for (int i = 0; i < 30; ++i) {
        Component c;
        out.connectTo(&c.in);
        ASSERT_TRUE(c.start());
        ASSERT_TRUE(soon([&] { return c.calls > 0; }));
        c.stop();
    }
    EXPECT_FALSE(out.connected());
}
