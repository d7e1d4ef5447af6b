// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Components that are destroyed while what scripts loaded refers to their attributes and properties.
#include "service_host.hpp"

#include <rtt/OperationCaller.hpp>

#include <gmock/gmock.h>

#include <memory>

namespace {

using service_test::Host;
using service_test::ServiceTest;
using testing::ElementsAre;
using testing::HasSubstr;

const char* const kGone =
    "component 'tank' was destroyed, but its attributes or properties are used here; load this again without it";

class PeersOfService : public ServiceTest {
protected:
    PeersOfService() {
        tank->addAttribute("level", level);
        tank->addProperty("name", name);
        tank->addOperation("pour", [this](int amount) { return poured += amount; });
        host.addPeer(tank.get());
        host.addOperation("unload", [this] {
            host.removePeer("tank");
            tank.reset();
        });
        host.addOperation("leave", [this] {
            host.removePeer("tank");
            tank.reset();
            return 1;
        });
    }

    int level = 5, poured = 0;
    std::string name = "red";
    std::unique_ptr<Host> tank = std::make_unique<Host>("tank");
};

TEST_F(PeersOfService, ThatGoFailTheProgramsThatUseThem) {
    ASSERT_TRUE(
        eval("program p {\n while true {\n  count = tank.level\n  yield\n }\n}\np.start()\n"
             "program other {\n while true {\n  note(\"other\")\n  yield\n }\n}\nother.start()\n"));
    host.step();
    EXPECT_EQ(5, host.count);
    tank.reset();
    level = 6;
    host.step();
    EXPECT_EQ(5, host.count);
    EXPECT_TRUE(service->inProgramError("p"));
    EXPECT_THAT(logged(), HasSubstr(std::string("program 'p' of component 'host' failed: ") + kGone));
    EXPECT_TRUE(service->pauseProgram("p") && service->startProgram("p"));
    host.step();
    EXPECT_TRUE(service->inProgramError("p")) << "for good";
    EXPECT_TRUE(service->stopProgram("p") && service->startProgram("p"));
    host.step();
    EXPECT_TRUE(service->inProgramError("p"));
    EXPECT_TRUE(service->isProgramRunning("other"));
    EXPECT_TRUE(service->unloadProgram("p"));
}

TEST_F(PeersOfService, ThatGoWithinAStepFailTheStatementThatDidIt) {
    ASSERT_TRUE(
        eval("void empty() { unload() }\n"
             "program p {\n try empty() catch { count = 9 }\n count = tank.level\n note(tank.name)\n}\n"
             "p.start()\n"));
    host.step();
    EXPECT_TRUE(service->inProgramError("p"));
    EXPECT_EQ(0, host.count) << "nothing catches that";
    EXPECT_THAT(host.notes, ElementsAre());
    EXPECT_EQ(3, service->getProgramLine("p"));
    EXPECT_THAT(logged(), HasSubstr(kGone));
}

TEST_F(PeersOfService, ThatGoExecuteNoOperations) {
    ASSERT_TRUE(
        eval("program p {\n while true {\n  try tank.pour(1) catch { note(\"caught\") }\n  yield\n }\n}\np.start()\n"
             "program other {\n while true {\n  tank.pour(10)\n  yield\n }\n}\nother.start()\n"));
    host.step();
    EXPECT_EQ(11, poured);
    tank.reset();
    host.step();
    EXPECT_EQ(11, poured);
    EXPECT_TRUE(service->isProgramRunning("p"));
    EXPECT_THAT(host.notes, ElementsAre("caught"));
    EXPECT_TRUE(service->inProgramError("other"));
    EXPECT_THAT(logged(), HasSubstr("operation 'pour' was not executed: the component that provides it was destroyed"));
}

TEST_F(PeersOfService, ThatGoWhileArgumentsAreEvaluatedExecuteNothing) {
    EXPECT_FALSE(eval("tank.pour(leave())\n"));
    EXPECT_EQ(0, poured);
    EXPECT_THAT(logged(), HasSubstr("operation 'pour' was not executed: the component that provides it was destroyed"));
}

TEST_F(PeersOfService, ThatGoAreSentNothing) {
    ASSERT_TRUE(
        eval("program p {\n var SendHandle h\n yield\n h = tank.pour.send(1)\n"
             " if h.collectIfDone() == SendFailure then note(\"refused\")\n}\np.start()\n"));
    host.step();
    tank.reset();
    host.step();
    EXPECT_EQ(0, poured);
    EXPECT_THAT(host.notes, ElementsAre("refused"));
}

TEST_F(PeersOfService, ThatGoFailTheStateMachinesThatUseThem) {
    ASSERT_TRUE(
        eval("StateMachine Sub { initial state a { run { count = tank.level } } final state b { } }\n"
             "StateMachine T {\n SubMachine Sub sub\n initial state a { entry { sub.activate(); sub.start() }\n"
             "  transition if tank.name == \"blue\" then select b }\n final state b { }\n}\n"
             "RootMachine T m\nm.activate()\nm.start()\n"));
    host.step(2);
    EXPECT_EQ(5, host.count);
    tank.reset();
    logged();
    host.step();
    EXPECT_TRUE(service->inStateMachineError("m"));
    EXPECT_TRUE(service->inStateMachineError("m.sub"));
    EXPECT_THAT(logged(), HasSubstr(std::string("state machine 'm' failed in state 'a': ") + kGone));
    EXPECT_TRUE(service->unloadStateMachine("m"));
}

TEST_F(PeersOfService, ThatGoFailTheCallsOfFunctionsThatUseThem) {
    ASSERT_TRUE(eval("export int level() { return tank.level }\n"));
    RTT::OperationCaller<int()> call(host.getOperation("level"));
    EXPECT_EQ(5, call());
    tank.reset();
    try {
        call();
        ADD_FAILURE() << "expected an exception";
    } catch (const std::runtime_error& e) {
        EXPECT_EQ(std::string("function 'level' of component 'host' failed at eval():1:12: ") + kGone, e.what());
    }
}

}  // namespace
