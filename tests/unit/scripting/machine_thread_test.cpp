// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Commands of several threads.
#include "machine_station.hpp"

#include <rtt/Activity.hpp>
#include <rtt/internal/GlobalEngine.hpp>

#include <atomic>
#include <future>
#include <thread>
#include <unistd.h>

namespace {

using namespace machine_test;

template <class Predicate>
bool eventually(Predicate&& predicate) {
    for (int i = 0; i != 100000; ++i) {
        if (predicate()) return true;
        usleep(200);
    }
    return false;
}

class MachineThreads : public MachineTest {
protected:
    MachineThreads() { RTT::Logger::Instance()->setLogLevel(RTT::Logger::Error); }
    ~MachineThreads() override {
        if (station.getActivity()) station.getActivity()->stop();
    }
    void runIn(Station& component, double period = 0.001) {
        ASSERT_TRUE(component.setActivity(new RTT::Activity(0, period, nullptr, component.getName())));
        component.getActivity()->start();
    }
};

const char* const kToggle = R"(
    StateMachine T {
        var int n = 0
        var int key
        initial state A {
            entry { n = n + 1 }
            run { n = n + 1 }
            transition pressed(key) if key == 1 then select B
            transition if n > 50 then { n = 0 } select B
        }
        state B {
            entry { n = n + 1; yield; n = n + 1 }
            transition if n > 3 then select A
        }
        final state Z { exit { n = 0 } }
    }
    RootMachine T m
)";

TEST_F(MachineThreads, MayCommandAndAskAtTheSameTime) {
    const StateMachinePtr m = load(kToggle);
    runIn(station);
    std::atomic<bool> stop{false};
    std::vector<std::thread> threads;
    RTT::OperationCaller<void(int)> pressed(station.getOperation("pressed"));
    const auto repeat = [&](auto action) {
        threads.emplace_back([&, action] {
            for (int i = 0; i != 300 && !stop; ++i) {
                action();
                usleep(300);
            }
        });
    };
    repeat([&] { m->activate(), m->start(); });
    repeat([&] { m->deactivate(); });
    repeat([&] { m->pause(), m->step(), m->start(); });
    repeat([&] { m->stop(), m->reset(), m->reactive(); });
    repeat([&] { m->requestState("Z"), m->requestState("B"), m->requestState("A"); });
    repeat([&] { pressed(1); });
    repeat([&] { m->getCurrentStateName(), m->getStatusStr(), m->inTransition(), m->getLineNumber(), m->getError(); });
    for (std::thread& thread : threads) thread.join();
    EXPECT_TRUE(service->unloadStateMachine("m"));
    EXPECT_EQ(m->getStatus(), Status::unloaded);
    EXPECT_EQ(logged(), "");
}

TEST_F(MachineThreads, CommandWaitsForTheEndOfASlice) {
    const StateMachinePtr m = load(R"(
        StateMachine T {
            initial state A { run { act(); note("slice") } exit { note("left") } }
            final state Z { }
        }
        RootMachine T m
    )");
    std::promise<void> inside, release;
    station.does = [&] {
        inside.set_value();
        release.get_future().wait();
    };
    m->activate();
    m->requestState("A");  // executes `run` once
    runIn(station);
    inside.get_future().wait();
    std::atomic<bool> done{false};
    std::thread other([&] {
        EXPECT_TRUE(m->deactivate());
        done = true;
    });
    EXPECT_EQ(m->getLineNumber(), 3) << "of a slice that has not come to its end";
    EXPECT_TRUE(m->pause()) << "does not wait";
    EXPECT_FALSE(done);
    release.set_value();
    other.join();
    EXPECT_EQ(m->getStatus(), Status::inactive);
    station.getActivity()->stop();
    EXPECT_EQ(station.take(), "slice left");
}

TEST_F(MachineThreads, CommandOfAComponentThatTheMachineCallsDoesNotDeadlock) {
    Station other("other");
    other.addOperation("serve", [] { return 5; }).doc("In its own thread");
    other.provides()->setOperationThread("serve", RTT::OwnThread);
    std::promise<void> running, inside;
    std::atomic<bool> commanded{false};
    station.addPeer(&other);
    const StateMachinePtr m = load(R"(
        StateMachine T {
            initial state A { run { act(); count = other.serve() } }
            final state Z { }
        }
        RootMachine T m
    )");
    // Its thread gives a command while the machine waits for it.
    other.addOperation("command", [&] {
        inside.set_value();
        commanded = m->requestState("Z");
    });
    other.provides()->setOperationThread("command", RTT::OwnThread);
    station.does = [&] {
        running.set_value();
        inside.get_future().wait();
    };
    runIn(other, 0);
    m->activate();
    m->requestState("A");
    runIn(station);
    running.get_future().wait();
    RTT::OperationCaller<void()> command(other.getOperation("command"), RTT::internal::GlobalEngine::Instance());
    auto sent = command.send();
    EXPECT_EQ(sent.collect(), RTT::SendSuccess);
    EXPECT_TRUE(commanded);
    EXPECT_TRUE(eventually([&] { return m->inFinalState(); }));
    EXPECT_TRUE(service->unloadStateMachine("m"));
    station.getActivity()->stop();
    other.getActivity()->stop();
    EXPECT_EQ(station.count, 5);
}

/** A machine that another thread is executing, until release(). */
struct BusyMachine : MachineThreads {
    StateMachinePtr hold() {
        const StateMachinePtr m = load(R"(
            StateMachine T {
                var int key
                initial state A { run { if busy() then act() } transition pressed(key) if seen(key) then select Z }
                final state Z { }
            }
            RootMachine T m
        )");
        m->activate();
        m->requestState("A");
        station.does = [this] {
            inside.set_value();
            released.get_future().wait();
        };
        other = std::thread([m] { m->execute(); });
        inside.get_future().wait();
        return m;
    }
    void release() {
        busy = false;
        released.set_value();
        other.join();
    }
    BusyMachine() {
        station.addOperation("busy", [this] { return busy.load(); });
        station.addOperation("seen", [this](int key) { return keys.push_back(key), false; });
    }

    std::vector<int> keys;  // of the events
    std::atomic<bool> busy{true};
    std::promise<void> inside, released;
    std::thread other;
};

TEST_F(BusyMachine, TakesEventsLaterInTheirOrder) {
    const StateMachinePtr m = hold();
    RTT::OperationCaller<void(int)> pressed(station.getOperation("pressed"));
    for (int key = 1; key != 4; ++key) pressed(key);
    EXPECT_THAT(keys, testing::IsEmpty());
    release();
    pressed(4);
    EXPECT_THAT(keys, testing::ElementsAre(1, 2, 3, 4));
    EXPECT_EQ(attribute<int>("key"), 4);
    EXPECT_EQ(logged("ERROR|Warning"), "");
}

TEST_F(BusyMachine, TellsHowManyEventsWereLost) {
    RTT::Logger::Instance()->setLogLevel(RTT::Logger::Warning);
    const StateMachinePtr m = hold();
    logged();
    RTT::OperationCaller<void(int)> pressed(station.getOperation("pressed"));
    for (int key = 1; key != 20; ++key) pressed(key);
    release();
    station.step();
    EXPECT_EQ(keys.size(), 16u);
    EXPECT_EQ(logged("Warning"),
              "state machine 'm' has lost 3 events: of each operation, 16 calls can wait for it, and then another "
              "thread had it, or its component was busy\n");
    for (int key = 20; key != 40; ++key) pressed(key);
    EXPECT_EQ(keys.size(), 36u);
    EXPECT_EQ(logged("Warning"), "");
}

TEST_F(MachineThreads, NoEventIsLostWhileAnotherGivesCommands) {
    std::atomic<int> sum{0}, sent{0};
    station.addOperation("counted", [&](int key) { return sum += key, false; });
    const StateMachinePtr m = load(R"(
        StateMachine T {
            var int key
            initial state A { transition pressed(key) if counted(key) then select Z }
            final state Z { }
        }
        RootMachine T m
    )");
    runIn(station, 0);
    m->activate();
    std::atomic<bool> stop{false};
    std::thread commander([&] {
        while (!stop) m->requestState("A"), m->reactive();
    });
    std::vector<std::thread> threads;
    for (int thread = 0; thread != 2; ++thread)
        threads.emplace_back([&] {
            RTT::OperationCaller<void(int)> pressed(station.getOperation("pressed"));
            for (int i = 0; i != 400; ++i) {
                ++sent;
                pressed(1);
                // So few that they find room.
                if (!eventually([&] { return sent - sum < 10; })) return;
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_TRUE(eventually([&] { return sum == 800; })) << sum;
    stop = true;
    commander.join();
}

TEST_F(MachineThreads, EventWakesAComponentWithoutPeriod) {
    const StateMachinePtr m = load(R"(
        StateMachine T {
            var int key
            initial state A { transition pressed(key) select B }
            state B { entry { count = key } }
            final state Z { }
        }
        RootMachine T m
    )");
    runIn(station, 0);
    m->activate();
    RTT::OperationCaller<void(int)> pressed(station.getOperation("pressed"));
    pressed(3);
    EXPECT_TRUE(eventually([&] { return m->inState("B"); }));
    EXPECT_TRUE(m->requestState("Z"));
    EXPECT_TRUE(eventually([&] { return m->inFinalState(); }));
}

TEST_F(MachineThreads, UnloadingInTheThreadOfTheComponentDoesNotBlock) {
    load(kToggle)->activate();
    runIn(station);
    bool unloaded = false;
    station.addOperation("unload", [&] { unloaded = service->unloadStateMachine("m"); });
    station.provides()->setOperationThread("unload", RTT::OwnThread);
    RTT::OperationCaller<void()>(station.getOperation("unload"), RTT::internal::GlobalEngine::Instance())();
    EXPECT_TRUE(unloaded);
}

}  // namespace
