// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// State machines as scripts write them.
#include "machine_station.hpp"

namespace {

using namespace machine_test;
using testing::ElementsAre;

class MachineScript : public MachineTest {};

const char* const kDoor = R"(
StateMachine Door {
    initial state Closed {
        entry { note("closed") }
        run { note("run") }
        handle { note("handle") }
        exit { note("leaves") }
        transitions {
            if go then { note("opens") } select Open
        }
    }
    state Open {
        entry { note("open"); yield; note("wide") }
        transition if !go then select Closed
    }
    final state Gone { entry { note("gone") } }
}
RootMachine Door m
)";

TEST_F(MachineScript, IsExecutedInTheOrderOfTheDescription) {
    const StateMachinePtr m = load(kDoor);
    EXPECT_EQ(m->getStatus(), Status::inactive);
    EXPECT_TRUE(m->activate());
    EXPECT_EQ(station.take(), "closed");
    EXPECT_TRUE(m->start());
    EXPECT_EQ(station.step(), "run handle run");
    EXPECT_EQ(station.step(), "handle run");
    station.go = true;
    EXPECT_EQ(station.step(), "opens leaves open");
    EXPECT_TRUE(m->inTransition());
    EXPECT_EQ(station.step(), "wide");
    EXPECT_EQ(m->getCurrentStateName(), "Open");
    EXPECT_TRUE(m->stop());
    EXPECT_EQ(station.step(), "gone");
    EXPECT_EQ(m->getStatusStr(), "stopped");
    EXPECT_TRUE(m->inFinalState());
    EXPECT_TRUE(m->deactivate());
    EXPECT_EQ(m->getStatusStr(), "inactive");
    EXPECT_EQ(logged(), "");
}

TEST_F(MachineScript, IsAServiceOfTheComponent) {
    load(kDoor);
    const auto m = station.provides()->getService("m");
    ASSERT_TRUE(m);
    EXPECT_THAT(m->getNames(), ElementsAre("activate", "automatic", "deactivate", "getState", "inError", "inFinalState",
                                           "inInitialState", "inState", "inTransition", "isActive", "isPaused",
                                           "isReactive", "isRunning", "pause", "reactive", "requestState", "reset",
                                           "start", "step", "stop", "trace"));
    RTT::OperationCaller<bool()> activate(m->getOperation("activate"));
    RTT::OperationCaller<bool(const std::string&)> request(m->getOperation("requestState")),
        in(m->getOperation("inState"));
    RTT::OperationCaller<std::string()> state(m->getOperation("getState"));
    EXPECT_EQ(state(), "");
    EXPECT_TRUE(activate());
    EXPECT_EQ(state(), "Closed");
    EXPECT_TRUE(in("Closed"));
    EXPECT_FALSE(in("Open"));
    EXPECT_FALSE(request("Nowhere"));
    EXPECT_FALSE(request("Open"));
    EXPECT_TRUE(request("Gone"));
    station.step();
    EXPECT_EQ(state(), "Gone");
}

TEST_F(MachineScript, CanBeCommandedByScripts) {
    load(kDoor);
    EXPECT_TRUE(service->eval(R"(
        var bool active = m.activate()
        if active && m.isReactive() && m.inState("Closed") && m.inInitialState then note("active")
        m.start
        if m.isRunning() && m.getState() == "Closed" then note("running")
        m.pause()
    )")) << logged();
    EXPECT_EQ(station.take(), "closed active running");
    station.step();
    EXPECT_EQ(service->getStateMachineStatusStr("m"), "paused");
}

TEST_F(MachineScript, CanCommandItself) {
    const StateMachinePtr m = load(R"(
        StateMachine T {
            initial state A {
                entry { m.start() }
                run { if count > 1 then m.requestState("Z"); count = count + 1 }
            }
            final state Z { entry { note("z"); m.stop() } }
        }
        RootMachine T m
    )");
    m->activate();
    EXPECT_TRUE(m->isRunning());
    for (int i = 0; i != 3; ++i) station.step();
    EXPECT_EQ(m->getCurrentStateName(), "Z");
    station.step();
    EXPECT_EQ(m->getStatus(), Status::stopped);
}

TEST_F(MachineScript, VariablesAndParametersAreAttributes) {
    const StateMachinePtr m = load(R"(
        var int five = 5
        StateMachine T {
            param int p
            param double q(3)
            var int sum = p + 1
            var string text
            const int twice = 2 * p
            alias int both = p + sum
            var bool flag = true, other
            initial state A {
                var int local = sum
                entry { text = "local " + local; sum = both; local = 100 }
                transition if sum == 11 then select B
            }
            state B { transition select A }
            final state Z { }
        }
        RootMachine T m(q = 2, p = five)
    )");
    EXPECT_EQ(attribute<int>("twice"), 10);
    m->activate();
    EXPECT_EQ(attribute<int>("p"), 5);
    EXPECT_EQ(attribute<double>("q"), 2.0);
    EXPECT_EQ(attribute<int>("sum"), 11);
    EXPECT_EQ(attribute<std::string>("text"), "local 6");
    EXPECT_TRUE(attribute<bool>("flag"));
    EXPECT_FALSE(attribute<bool>("other"));
    m->start();
    station.step();
    EXPECT_EQ(m->getCurrentStateName(), "B");
    station.step();
    EXPECT_EQ(attribute<std::string>("text"), "local 11") << "variables of a state are assigned with each entry";
    m->deactivate();
    m->activate();
    EXPECT_EQ(attribute<int>("sum"), 11) << "variables are assigned with each activation";
}

TEST_F(MachineScript, ValuesOfParametersAreComputedWhenItIsActivated) {
    const StateMachinePtr m = load(R"(
        StateMachine T {
            param int p
            initial state A { }
            final state Z { }
        }
        RootMachine T m(p = count)
    )");
    station.count = 7;
    m->activate();
    EXPECT_EQ(attribute<int>("p"), 7);
    station.count = 8;
    m->deactivate();
    m->activate();
    EXPECT_EQ(attribute<int>("p"), 8);
}

TEST_F(MachineScript, TypesMayBeUsedSeveralTimesAndLater) {
    ASSERT_TRUE(service->eval(R"(
        StateMachine T {
            param string name
            var int n = 0
            initial state A { entry { n = n + 1; note(name + n) } }
            final state Z { }
        }
        RootMachine T one(name = "one")
        RootMachine T two(name = "two")
    )")) << logged();
    ASSERT_TRUE(service->eval("RootMachine T m(name = \"three\")")) << logged();
    ASSERT_TRUE(service->eval("one.activate()\ntwo.activate()\nm.activate()")) << logged();
    EXPECT_EQ(station.take(), "one1 two1 three1");
}

TEST_F(MachineScript, PreconditionsAndAlternatives) {
    const StateMachinePtr m = load(R"(
        StateMachine T {
            initial state A { transition if go then select B or C }
            state B {
                precondition count > 0
                precondition count < 10
            }
            state C { precondition count < 0 }
            final state Z { }
        }
        RootMachine T m
    )");
    m->activate();
    m->start();
    station.go = true;
    station.step();
    station.step();
    EXPECT_EQ(m->getCurrentStateName(), "A");
    station.count = -1;
    station.step();
    EXPECT_EQ(m->getCurrentStateName(), "C");
}

TEST_F(MachineScript, TransitionsOfAllStatesElseAndSelf) {
    const StateMachinePtr m = load(R"(
        StateMachine T {
            transition if count == 9 then select Z
            initial state A {
                transition if go then { note("self") } else { note("away") } select B
                exit { note("never to self") }
            }
            state B { }
            final state Z { }
        }
        RootMachine T m
    )");
    station.go = true;
    m->activate();
    m->start();
    EXPECT_EQ(station.step(), "self");
    EXPECT_EQ(station.step(), "self");
    station.go = false;
    EXPECT_EQ(station.step(), "away never to self");
    station.step();
    station.count = 9;
    station.step();
    EXPECT_EQ(m->getCurrentStateName(), "Z");
}

TEST_F(MachineScript, TraceIsInTheLog) {
    const StateMachinePtr m = load(kDoor);
    m->activate();
    logged("Info");
    EXPECT_TRUE(service->eval("m.trace(true)"));
    m->start();
    station.go = true;
    station.step();
    m->pause();
    station.step();
    EXPECT_THAT(logged("Info"), testing::HasSubstr("[running] state machine 'm' runs in state 'Closed'\n"
                                                   "[running] state machine 'm' enters state 'Open'\n"
                                                   "[paused] state machine 'm' pauses in state 'Open'\n"));
}

TEST_F(MachineScript, StatesAreListedInTheirOrder) {
    const StateMachinePtr m = load(kDoor);
    EXPECT_THAT(m->getStateList(), ElementsAre("Closed", "Open", "Gone"));
    EXPECT_EQ(m->getName(), "m");
    EXPECT_THAT(m->getText(), testing::StartsWith("StateMachine Door {"));
    EXPECT_TRUE(m->getChildren().empty());
    EXPECT_EQ(m->getService(), station.provides()->getService("m"));
}

TEST_F(MachineScript, IsExecutedWhileTheComponentIsStopped) {
    const StateMachinePtr m = load(kDoor);
    station.start();
    m->activate();
    m->start();
    EXPECT_EQ(station.step(), "run handle run");
    station.stop();
    EXPECT_EQ(station.step(), "handle run");
}

TEST_F(MachineScript, UnloadingStopsAndDeactivates) {
    const StateMachinePtr m = load(kDoor);
    m->activate();
    m->start();
    station.take();
    EXPECT_TRUE(service->unloadStateMachine("m"));
    EXPECT_EQ(station.take(), "leaves gone");
    EXPECT_EQ(m->getStatusStr(), "unloaded");
    EXPECT_FALSE(station.provides()->hasService("m"));
    EXPECT_FALSE(m->activate());
    EXPECT_FALSE(m->stop());
    EXPECT_FALSE(m->isActive());
    station.step();
}

}  // namespace
