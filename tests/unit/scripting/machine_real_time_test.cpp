// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a state machine does in its cycles neither allocates nor locks.
#include "machine_station.hpp"

#include <support/real_time_trap.hpp>

namespace {

using namespace machine_test;
using oroforge::test::expectRealTime;

class MachineRealTime : public MachineTest {
protected:
    void cycles(StateMachine& machine, int count) {
        for (int i = 0; i != count; ++i) machine.execute();
    }
};

const char* const kCounter = R"(
    StateMachine T {
        var int x
        var double y = 0.5
        var int rounds = 0
        transition if x < 0 then select Z
        initial state A {
            var int here = 3
            precondition rounds >= 0
            entry { here = rounds }
            run { x = x + 1; y = y * 1.5 + x }
            handle { if y > 100.0 then y = 0.0 }
            exit { here = 0 }
            transition in(x) { y = x } select B
            transition if x > 10 then { rounds = rounds + 1 } select Z or B else { y = y + 1.0 }
        }
        state B {
            entry { x = 0; yield; x = 1 }
            run { for (var int i = 0; i < 3; i = i + 1) { y = y - i } }
            transition select A
        }
        final state Z { precondition false }
    }
    RootMachine T m
)";

TEST_F(MachineRealTime, CyclesTransitionsAndPorts) {
    OROFORGE_NEEDS_REAL_TIME_TRAP();
    const StateMachinePtr m = load(kCounter);
    m->activate();
    m->start();
    cycles(*m, 200);
    EXPECT_GT(attribute<int>("rounds"), 5);
    station.out.write(5);
    expectRealTime([&] {
        cycles(*m, 500);
        station.out.write(7);
        cycles(*m, 500);
    });
    EXPECT_TRUE(m->isRunning()) << m->getError();
}

TEST_F(MachineRealTime, CommandsAndQueries) {
    OROFORGE_NEEDS_REAL_TIME_TRAP();
    const StateMachinePtr m = load(kCounter);
    const std::string b = "B", z = "Z";
    m->activate();
    expectRealTime([&] {
        m->start();
        cycles(*m, 3);
        m->pause();
        cycles(*m, 2);
        m->step();
        cycles(*m, 2);
        m->reactive();
        m->requestState(b);
        cycles(*m, 5);
        m->requestState(z);
        cycles(*m, 5);
        m->inState(b);
        m->getStatus();
        m->getLineNumber();
        m->stop();
        cycles(*m, 3);
        m->reset();
        m->deactivate();
        m->activate();
    });
    EXPECT_EQ(m->getCurrentStateName(), "A");
}

TEST_F(MachineRealTime, EventsInItsOwnThread) {
    OROFORGE_NEEDS_REAL_TIME_TRAP();
    const StateMachinePtr m = load(R"(
        StateMachine T {
            var int key
            initial state A { transition pressed(key) if key > 0 then select B }
            state B { transition pressed(key) if key > 0 then select A }
            final state Z { }
        }
        RootMachine T m
    )");
    m->activate();
    RTT::OperationCaller<void(int)> pressed(station.getOperation("pressed"), station.engine());
    pressed(1);
    cycles(*m, 2);
    expectRealTime([&] {
        for (int i = 0; i != 10; ++i) {
            pressed(0);
            pressed(1);
            cycles(*m, 1);
        }
    });
    EXPECT_EQ(m->getCurrentStateName(), "B");
}

TEST_F(MachineRealTime, EventsOfOtherThreads) {
    OROFORGE_NEEDS_REAL_TIME_TRAP();
    const StateMachinePtr m = load(R"(
        StateMachine T {
            var int key
            initial state A { transition pressed(key) { count = count + key } }
            final state Z { }
        }
        RootMachine T m
    )");
    m->activate();
    RTT::OperationCaller<void(int)> pressed(station.getOperation("pressed"));
    ASSERT_TRUE(station.setActivity(new RTT::Activity(0, 0.0, nullptr, "station")));
    station.getActivity()->start();
    pressed(1);
    expectRealTime([&] {
        for (int i = 0; i != 40; ++i) pressed(1);
    });
    station.getActivity()->stop();
}

}  // namespace
