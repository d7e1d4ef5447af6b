// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Components and event ports that come and go while samples flow through them.
#include "samples.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/Port.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/internal/flow/reclaimer.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <thread>

using namespace RTT;
using namespace flow_test;

namespace {

/** Passes on what it gets, in its own thread. */
class Node final : public TaskContext {
public:
    explicit Node(int number) : TaskContext("node" + std::to_string(number)) {
        addPort(out);
        addEventPort(in, [this](base::PortInterface*) {
            Deep sample;
            if (in.read(sample) != NewData) return;
            if (!intact(sample)) ++torn;
            ++passed;
            (void)out.write(sample);
        });
    }
    ~Node() override { stop(); }

    InputPort<Deep> in{"in"};
    OutputPort<Deep> out{"out"};
    static std::atomic<unsigned> torn, passed;
};
std::atomic<unsigned> Node::torn{0}, Node::passed{0};

/** Writes without pause. */
class Source {
public:
    Source()
        : thread_([this] {
              Deep sample;
              for (std::uint64_t n = 1; !stop_; ++n) {
                  fill(sample, 0, n);
                  (void)out.write(sample);
                  if (n % 4 == 0) std::this_thread::yield();
              }
          }) {}
    ~Source() {
        stop_ = true;
        thread_.join();
    }
    OutputPort<Deep> out{"source"};

private:
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

template <class Condition>
bool soon(Condition condition) {
    for (int i = 0; i < 20000 && !condition(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return condition();
}

}  // namespace

TEST(ComponentStorm, MembersOfAChainAreReplacedDuringTraffic) {
    constexpr int kNodes = 3;
    Node::torn = 0;
    std::unique_ptr<Node> nodes[kNodes];
    Source source;
    const auto place = [&](int i) {
        nodes[i].reset();
        nodes[i].reset(new Node(i));
        const ConnPolicy policy = i % 2 ? ConnPolicy::data() : ConnPolicy::circularBuffer(3);
        if (i == 0) {
            ASSERT_TRUE(source.out.connectTo(&nodes[i]->in, policy));
        }
        if (i > 0 && nodes[i - 1]) {
            ASSERT_TRUE(nodes[i - 1]->out.connectTo(&nodes[i]->in, policy));
        }
        if (i + 1 < kNodes && nodes[i + 1]) {
            ASSERT_TRUE(nodes[i]->out.connectTo(&nodes[i + 1]->in, policy));
        }
        ASSERT_TRUE(nodes[i]->start());
    };
    for (int i = 0; i < kNodes; ++i) place(i);
    const std::uint64_t rounds = stressCount(60);
    for (std::uint64_t round = 0; round < rounds; ++round) {
        place(static_cast<int>(round % kNodes));
        const unsigned before = Node::passed;
        ASSERT_TRUE(soon([&] { return Node::passed > before; }));
    }
    EXPECT_EQ(Node::torn, 0u);
}

TEST(ComponentStorm, PortsComeAndGoInARunningComponent) {
    Source source;
    TaskContext component("component");
    ASSERT_TRUE(component.start());
    const std::uint64_t rounds = stressCount(60);
    for (std::uint64_t round = 0; round < rounds; ++round) {
        std::atomic<unsigned> calls{0}, torn{0};
        InputPort<Deep> port("temporary"), other("other");
        component.addEventPort(port, [&](base::PortInterface*) {
            Deep sample;
            if (port.read(sample) == NewData && !intact(sample)) ++torn;
            ++calls;
        });
        component.addPort(other);
        ASSERT_TRUE(source.out.connectTo(&port, round % 2 ? ConnPolicy::data() : ConnPolicy::buffer(4)));
        ASSERT_TRUE(source.out.connectTo(&other));
        ASSERT_TRUE(soon([&] { return calls > 0; }));
        if (round % 3 == 0) {
            component.ports()->removePort("temporary");
            EXPECT_FALSE(port.connected());
            const unsigned seen = calls;  // nothing calls back once it is out
            std::this_thread::yield();
            EXPECT_EQ(calls, seen);
        }
        EXPECT_EQ(torn, 0u);
    }
    component.stop();
}

TEST(ComponentStorm, StartAndStopDuringTrafficLoseNoWakeUp) {
    Source source;
    Node node(0);
    ASSERT_TRUE(source.out.connectTo(&node.in, ConnPolicy::data()));
    const std::uint64_t rounds = stressCount(100);
    for (std::uint64_t round = 0; round < rounds; ++round) {
        const unsigned before = Node::passed;
        ASSERT_TRUE(node.start());
        ASSERT_TRUE(soon([&] { return Node::passed > before; }));
        ASSERT_TRUE(node.stop());
    }
}

TEST(EventPortRemoval, WaitsForTheCallbackThatExecutes) {
    OutputPort<int> out("out");
    TaskContext component("component");
    std::atomic<bool> entered{false}, leave{false}, left{false};
    std::unique_ptr<InputPort<int>> in(new InputPort<int>("in"));
    component.addEventPort(*in, [&](base::PortInterface*) {
        entered = true;
        while (!leave) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        left = true;
    });
    out.connectTo(in.get());
    ASSERT_TRUE(component.start());
    out.write(1);
    ASSERT_TRUE(soon([&] { return entered.load(); }));
    bool leftBefore = false;
    std::thread remover([&] {
        in.reset();
        leftBefore = left;
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    leave = true;
    remover.join();
    EXPECT_TRUE(leftBefore);
    component.stop();
}

TEST(EventPortRemoval, WithinTheCallbackDoesNotWaitForItself) {
    OutputPort<int> out("out");
    TaskContext component("component");
    std::atomic<bool> removed{false};
    std::unique_ptr<InputPort<int>> in(new InputPort<int>("in"));
    component.addEventPort(*in, [&](base::PortInterface*) {
        in.reset();
        removed = true;
    });
    out.connectTo(in.get());
    ASSERT_TRUE(component.start());
    out.write(1);
    EXPECT_TRUE(soon([&] { return removed.load(); }));
    component.stop();
    EXPECT_FALSE(out.connected());
}

namespace {

/** Counts what it is told about its ports, and can be held up within a message. */
class Held final : public TaskContext {
public:
    explicit Held(bool stops) : TaskContext("held"), stops_(stops) {
        addOperation("hold", &Held::hold, this, OwnThread);
        addEventPort(*in);
    }
    ~Held() override { stop(); }

    std::unique_ptr<InputPort<int>> in{new InputPort<int>("in")};
    std::atomic<bool> entered{false}, leave{false};
    std::atomic<int> told{0};

protected:
    void dataOnPortCallback(base::PortInterface* port) override {
        ++told;
        TaskContext::dataOnPortCallback(port);
    }

private:
    void hold() {
        entered = true;
        while (!leave) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        if (stops_) stop();
    }
    const bool stops_;
};

}  // namespace

// Its pointer may dangle; and where the component has stopped meanwhile its class may be under destruction.
TEST(EventPortRemoval, APortThatIsQueuedIsForgotten) {
    for (const bool stops : {false, true}) {
        SCOPED_TRACE(stops ? "in a component that stops" : "in a running component");
        OutputPort<int> out("out");
        Held component(stops);
        ASSERT_TRUE(out.connectTo(component.in.get()));
        ASSERT_TRUE(component.start());
        OperationCaller<void()> hold(component.getOperation("hold"), internal::GlobalEngine::Instance());
        const SendHandle<void()> held = hold.send();
        ASSERT_TRUE(soon([&] { return component.entered.load(); }));
        out.write(1);
        component.in.reset();
        component.leave = true;
        ASSERT_EQ(held.collect(), SendSuccess);
        component.stop();
        component.start();  // what was queued has been looked at
        component.stop();
        EXPECT_EQ(component.told, 0);
    }
}

namespace {

/** Looks at its port before it calls the callback. */
class Looking final : public TaskContext {
public:
    Looking() : TaskContext("looking") { addEventPort(*in); }
    ~Looking() override { stop(); }

    std::unique_ptr<InputPort<int>> in{new InputPort<int>("in")};
    std::atomic<bool> entered{false}, leave{false}, left{false};

protected:
    void dataOnPortCallback(base::PortInterface* port) override {
        entered = true;
        while (!leave) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        EXPECT_EQ(port->getName(), "in");
        TaskContext::dataOnPortCallback(port);
        left = true;
    }
};

}  // namespace

TEST(EventPortRemoval, WaitsForTheHookOfTheComponent) {
    OutputPort<int> out("out");
    Looking component;
    ASSERT_TRUE(out.connectTo(component.in.get()));
    ASSERT_TRUE(component.start());
    out.write(1);
    ASSERT_TRUE(soon([&] { return component.entered.load(); }));
    bool leftBefore = false;
    std::thread remover([&] {
        component.in.reset();
        leftBefore = component.left;
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    component.leave = true;
    remover.join();
    EXPECT_TRUE(leftBefore);
}

TEST(EventPortRemoval, OfEachOthersPortsWithinTwoCallbacksEnds) {
    OutputPort<int> out("out");
    TaskContext left("left"), right("right");
    InputPort<int> atLeft("at_left"), atRight("at_right");
    std::atomic<int> inside{0}, removed{0};
    const auto removing = [&](TaskContext& other, const char* port) {
        return [&, port](base::PortInterface*) {
            ++inside;
            while (inside < 2) std::this_thread::sleep_for(std::chrono::milliseconds(1));
            other.ports()->removePort(port);
            ++removed;
        };
    };
    left.addEventPort(atLeft, removing(right, "at_right"));
    right.addEventPort(atRight, removing(left, "at_left"));
    out.connectTo(&atLeft);
    out.connectTo(&atRight);
    ASSERT_TRUE(left.start() && right.start());
    out.write(1);
    EXPECT_TRUE(soon([&] { return removed == 2; }));
    left.stop();
    right.stop();
}
