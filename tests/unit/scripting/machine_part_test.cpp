// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Sub machines, events and ports of state machines.
#include "machine_station.hpp"

#include <thread>

namespace {

using namespace machine_test;
using testing::HasSubstr;

class SubMachine : public MachineTest {
protected:
    const char* const script = R"(
        StateMachine Wheel {
            param int speed
            var int turns = 0
            initial state Still { entry { note("still") } exit { note("starts") } transition if speed > 0 then select Turning }
            state Turning { run { turns = turns + speed } }
            final state Broken { entry { note("broken") } }
        }
        StateMachine Car {
            param int gear
            var int fast = gear * 10
            SubMachine Wheel left(speed = gear)
            SubMachine Wheel right(speed = fast)
            initial state Parked {
                transition if go then { left.activate(); right.activate(); left.start(); right.start() } select Driving
            }
            state Driving { run { count = left.turns + right.turns } }
            final state Wreck { entry { left.stop() } }
        }
        RootMachine Car m(gear = 2)
    )";
};

TEST_F(SubMachine, IsDrivenByItsParent) {
    const StateMachinePtr m = load(script);
    m->activate();
    m->start();
    station.go = true;
    EXPECT_EQ(station.step(), "still still starts starts") << "each has its cycle after that of the parent";
    EXPECT_EQ(m->getCurrentStateName(), "Driving");
    for (int i = 0; i != 4; ++i) station.step();
    EXPECT_EQ(attribute<int>("speed", "m.left"), 2);
    EXPECT_EQ(attribute<int>("speed", "m.right"), 20);
    EXPECT_EQ(attribute<int>("turns", "m.right"), 10 * attribute<int>("turns", "m.left"));
    EXPECT_GT(station.count, 0);
}

TEST_F(SubMachine, HasANameAServiceAndAStatusOfItsOwn) {
    const StateMachinePtr m = load(script);
    ASSERT_EQ(m->getChildren().size(), 2u);
    const StateMachinePtr left = m->getChildren()[0];
    EXPECT_EQ(left->getName(), "m.left");
    EXPECT_EQ(service->getStateMachine("m.left"), left);
    EXPECT_EQ(left->getStatusStr(), "inactive");
    EXPECT_TRUE(service->eval("m.left.activate()")) << logged();
    EXPECT_TRUE(left->isActive());
    EXPECT_FALSE(m->isActive());
}

TEST_F(SubMachine, GoesOnWhenItsParentStops) {
    const StateMachinePtr m = load(script);
    m->activate();
    m->start();
    station.go = true;
    for (int i = 0; i != 3; ++i) station.step();
    m->stop();
    station.step();
    station.step();
    EXPECT_EQ(m->getStatus(), Status::stopped);
    EXPECT_EQ(service->getStateMachineStatusStr("m.left"), "stopped") << "the parent told it to";
    EXPECT_EQ(service->getStateMachineStatusStr("m.right"), "running");
    EXPECT_TRUE(m->deactivate());
    EXPECT_EQ(service->getStateMachineStatusStr("m.right"), "running");
}

TEST_F(SubMachine, IsInTheStateThatItsParentRequestsAtOnce) {
    const StateMachinePtr m = load(R"(
        StateMachine Valve {
            initial state Closed { entry { note("closed") } exit { note("opens") } }
            state Half { transition select Closed }
            final state Open { entry { note("open") } }
        }
        StateMachine Pipe {
            SubMachine Valve valve
            initial state Idle {
                entry { valve.activate(); note("" + valve.requestState("Open") + valve.getState()) }
                run { note("" + valve.requestState("Closed") + valve.getState()) }
                exit { note("" + valve.requestState("Open") + valve.getState()) }
                transition if go then { note("" + valve.requestState("Half") + valve.getState()) } select End
            }
            final state End { }
        }
        RootMachine Pipe m
    )");
    EXPECT_TRUE(m->activate());
    EXPECT_EQ(station.take(), "closed opens open trueOpen");
    m->start();
    EXPECT_EQ(station.step(), "closed trueClosed trueClosed");
    station.go = true;
    EXPECT_EQ(station.step(), "falseClosed opens open trueOpen");
}

TEST_F(SubMachine, ErrorDoesNotReachItsParent) {
    const StateMachinePtr m = load(R"(
        StateMachine Part { initial state A { run { count = 1 / 0 } } final state Z { } }
        StateMachine Whole {
            SubMachine Part part
            initial state A { entry { part.activate(); part.start() } transition if part.inError then select B }
            state B { entry { note("part failed in " + part.getState()) } }
            final state Z { }
        }
        RootMachine Whole m
    )");
    m->activate();
    m->start();
    station.step();
    EXPECT_FALSE(m->inError());
    EXPECT_EQ(station.step() + station.step(), "part failed in A");
}

TEST_F(SubMachine, IsUnloadedWithItsParentWhoseProgramsMayStillCommandIt) {
    const StateMachinePtr m = load(R"(
        StateMachine Part { initial state A { exit { note("part leaves") } } final state Z { entry { note("part ends") } } }
        StateMachine Whole {
            SubMachine Part part
            initial state A { entry { part.activate() } exit { part.deactivate(); while part.isActive() { yield } } }
            final state Z { }
        }
        RootMachine Whole m
    )");
    m->activate();
    EXPECT_TRUE(service->unloadStateMachine("m"));
    EXPECT_EQ(station.take(), "part leaves");
    EXPECT_TRUE(service->getStateMachineList().empty());
}

class PortEvent : public MachineTest {};

TEST_F(PortEvent, IsNewData) {
    const StateMachinePtr m = load(R"(
        StateMachine T {
            var int x
            initial state A { transition in(x) if x > 5 then { note("big") } select B else { note("small") } }
            state B { }
            final state Z { }
        }
        RootMachine T m
    )");
    m->activate();
    m->start();
    EXPECT_EQ(station.step(), "");
    station.out.write(3);
    EXPECT_EQ(station.step(), "small");
    EXPECT_EQ(station.step(), "") << "old data";
    EXPECT_EQ(attribute<int>("x"), 3);
    station.out.write(8);
    EXPECT_EQ(station.step(), "big");
    EXPECT_EQ(m->getCurrentStateName(), "B");
}

TEST_F(PortEvent, IsSeenByAllTransitionsOfACycle) {
    const StateMachinePtr m = load(R"(
        StateMachine T {
            var int x
            var int y
            transition in(y) select Z
            initial state A { transition in(x) if x == 1 then select B }
            state B { }
            final state Z { }
        }
        RootMachine T m
    )");
    m->activate();
    m->start();
    station.out.write(2);
    station.step();
    EXPECT_EQ(m->getCurrentStateName(), "Z");
    EXPECT_EQ(attribute<int>("x"), 2);
    EXPECT_EQ(attribute<int>("y"), 2);
}

TEST_F(PortEvent, NeedsNoVariable) {
    const StateMachinePtr m = load(R"(
        StateMachine T {
            initial state A { transition this.in() select Z }
            final state Z { }
        }
        RootMachine T m
    )");
    m->activate();
    m->start();
    station.out.write(2);
    station.step();
    EXPECT_TRUE(m->inFinalState());
}

TEST_F(PortEvent, OfAComponentThatIsGoneDoesNotHappen) {
    auto other = std::make_unique<Station>("other");
    station.addPeer(other.get());
    const StateMachinePtr m = load(R"(
        StateMachine T {
            var int x
            initial state A { transition other.in(x) select B; transition in() { note("own") } }
            state B { }
            final state Z { }
        }
        RootMachine T m
    )");
    m->activate();
    m->start();
    other.reset();
    EXPECT_EQ(station.step(), "");
    station.out.write(1);
    EXPECT_EQ(station.step(), "own");
    EXPECT_EQ(m->getStatus(), Status::running);
    EXPECT_TRUE(service->unloadStateMachine("m"));
}

class OperationEvent : public MachineTest {
protected:
    const char* const script = R"(
        StateMachine T {
            var int key
            var double far
            var string where
            transition moved(far, where) select Z
            initial state A {
                transition pressed(key) if key > 5 then { note("high") } select B else { note("low") } select C
            }
            state B { entry { note("b") } }
            state C { entry { note("c") } }
            final state Z { entry { note(where) } }
        }
        RootMachine T m
    )";
    RTT::OperationCaller<void(int)> pressed{station.getOperation("pressed")};
    RTT::OperationCaller<void(double, const std::string&)> moved{station.getOperation("moved")};
};

TEST_F(OperationEvent, IsACallAndChangesTheStateInTheNextStep) {
    const StateMachinePtr m = load(script);
    m->activate();
    pressed(8);
    EXPECT_EQ(m->getCurrentStateName(), "A");
    EXPECT_TRUE(m->inTransition());
    EXPECT_EQ(attribute<int>("key"), 8);
    EXPECT_EQ(station.step(), "high b");
    pressed(1);
    EXPECT_EQ(attribute<int>("key"), 8) << "this state does not listen";
    moved(2.5, "home");
    EXPECT_EQ(station.step(), "home");
    EXPECT_EQ(attribute<double>("far"), 2.5);
}

TEST_F(OperationEvent, TakesTheElse) {
    const StateMachinePtr m = load(script);
    m->activate();
    pressed(1);
    EXPECT_EQ(station.step(), "low c");
}

TEST_F(OperationEvent, IsLostIfTheMachineIsNotActive) {
    const StateMachinePtr m = load(script);
    pressed(8);
    EXPECT_EQ(attribute<int>("key"), 0);
    m->activate();
    EXPECT_EQ(station.step(), "");
    EXPECT_TRUE(service->unloadStateMachine("m"));
    pressed(8);
    moved(1.0, "");
}

TEST_F(OperationEvent, OfAnotherThreadIsHandedToTheThreadOfTheMachine) {
    const StateMachinePtr m = load(script);
    m->activate();
    std::thread other([&] { pressed(8); });
    other.join();
    EXPECT_FALSE(m->inTransition()) << "still in the queue of the component";
    EXPECT_EQ(station.step(), "high b");
}

TEST_F(OperationEvent, MayComeFromAProgramOfTheMachine) {
    const StateMachinePtr m = load(R"(
        StateMachine T {
            var int key
            initial state A { run { pressed(4); note("pressed") } transition pressed(key) select B }
            state B { entry { note("b" + key) } }
            final state Z { }
        }
        RootMachine T m
    )");
    m->activate();
    m->start();
    EXPECT_EQ(station.step(), "pressed b4");
}

TEST_F(OperationEvent, OfAPeerOrServiceIsNamedByItsPath) {
    Station other("other");
    station.addPeer(&other);
    station.provides("panel")->addEventOperation("push", [] {});
    const StateMachinePtr m = load(R"(
        StateMachine T {
            var int key
            initial state A { transition other.pressed(key) select B }
            state B { transition panel.push() select Z }
            final state Z { }
        }
        RootMachine T m
    )");
    m->activate();
    RTT::OperationCaller<void(int)>(other.getOperation("pressed"))(3);
    station.step();
    EXPECT_EQ(m->getCurrentStateName(), "B");
    RTT::OperationCaller<void()>(station.provides("panel")->getOperation("push"))();
    station.step();
    EXPECT_TRUE(m->inFinalState());
    EXPECT_TRUE(service->unloadStateMachine("m"));
    station.removePeer("other");
}

/** The messages for a machine whose first state has this transition. */
class EventMessage : public MachineTest {
protected:
    std::string messages(const std::string& transition) {
        EXPECT_FALSE(
            service->eval("StateMachine T {\n  var int i\n  var string s\n  initial state A {\n    transition " +
                          transition + "\n  }\n  final state Z { }\n}\nRootMachine T m\n"));
        EXPECT_FALSE(station.provides()->hasService("m"));
        return logged();
    }
};

TEST_F(EventMessage, OwnNamesComeBeforePeers) {
    RTT::TaskContext task("task");
    ASSERT_TRUE(station.addPeer(&task));
    EXPECT_THAT(messages("task.presed(i) select Z"), HasSubstr("'station' has no operation or input port 'presed'"));
    station.removePeer("task");
}

TEST_F(EventMessage, UnknownName) {
    EXPECT_EQ(
        messages("presed(i) select Z"),
        "eval():5:16: error: [OPS312] 'station' has no operation or input port 'presed'; did you mean 'pressed'?\n"
        "    transition presed(i) select Z\n"
        "               ^\n");
    EXPECT_EQ(messages("out(i) select Z"),
              "eval():5:16: error: [OPS312] 'station' has no operation or input port 'out'\n"
              "    transition out(i) select Z\n"
              "               ^\n");
    EXPECT_EQ(messages("nobody.in(i) select Z"),
              "eval():5:16: error: [OPS311] 'station' has no peer or service 'nobody'\n"
              "    transition nobody.in(i) select Z\n"
              "               ^\n");
}

TEST_F(EventMessage, NoSignal) {
    EXPECT_EQ(messages("quiet(i) select Z"),
              "eval():5:16: error: [OPS313] calls of operation 'quiet' cannot be listened to\n"
              "    transition quiet(i) select Z\n"
              "               ^\n"
              "note: its component has to add it with addEventOperation()\n");
}

TEST_F(EventMessage, Arguments) {
    EXPECT_EQ(messages("pressed() select Z"),
              "eval():5:16: error: [OPS314] operation 'pressed' has 1 argument, found 0 variables for it\n"
              "    transition pressed() select Z\n"
              "               ^\n");
    EXPECT_EQ(messages("moved(i) select Z"),
              "eval():5:16: error: [OPS314] operation 'moved' has 2 arguments, found 1 variable for them\n"
              "    transition moved(i) select Z\n"
              "               ^\n");
    EXPECT_EQ(messages("pressed(s) select Z"),
              "eval():5:24: error: [OPS314] expected a variable of type int, found one of type string\n"
              "    transition pressed(s) select Z\n"
              "                       ^\n");
    EXPECT_EQ(messages("pressed(3) select Z"),
              "eval():5:24: error: [OPS314] expected a variable of type int, found something else\n"
              "    transition pressed(3) select Z\n"
              "                       ^\n");
    EXPECT_EQ(messages("in(s) select Z"),
              "eval():5:19: error: [OPS314] expected a variable of type int, found one of type string\n"
              "    transition in(s) select Z\n"
              "                  ^\n");
    EXPECT_EQ(messages("in(i, i) select Z"),
              "eval():5:22: error: [OPS314] port 'in' gives one value, found 2 variables\n"
              "    transition in(i, i) select Z\n"
              "                     ^\n");
}

}  // namespace
