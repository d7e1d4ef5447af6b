// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Sending, collecting, commands.
#include "script_fixture.hpp"

#include <rtt/Activity.hpp>
#include <rtt/SendStatus.hpp>

#include <atomic>

using namespace RTT;

namespace {

class Sending : public ScriptTest {
protected:
    Sending() : arm("arm") {
        arm.addOperation(
            "square", [](double x) { return x * x; }, OwnThread);
        arm.addOperation(
            "halve", [](double& x) { x /= 2; }, OwnThread);
        component.connectPeers(&arm);
        arm.start();
    }
    ~Sending() override { arm.stop(); }

    TaskContext arm;
};

}  // namespace

TEST_F(Sending, CollectsTheResult) {
    ASSERT_TRUE(run("var SendHandle h\nvar double y\nh = arm.square.send(3)\nvar SendStatus s = h.collect(y)"))
        << messages();
    EXPECT_EQ(value<double>("y"), 9.0);
    EXPECT_EQ(value<SendStatus>("s"), SendSuccess);
}

TEST_F(Sending, PollsUntilItIsDone) {
    ASSERT_TRUE(
        run("program p {\n  var SendHandle h = arm.square.send(4.0)\n  var double y\n"
            "  while (h.collectIfDone(y) == SendNotReady) yield\n  arm.square(y)\n}"))
        << messages();
}

TEST_F(Sending, ArgumentsByReferenceAreCollected) {
    ASSERT_TRUE(run("var SendHandle h\nvar double x = 3\nh = arm.halve.send(x)\nvar double half\nh.collect(half)"))
        << messages();
    EXPECT_EQ(value<double>("half"), 1.5);
}

TEST_F(Sending, CommandsYieldUntilTheyAreDone) {
    ASSERT_TRUE(run("var SendStatus s\ns = arm.square.cmd(3)")) << messages();
    EXPECT_EQ(value<SendStatus>("s"), SendSuccess);
}

TEST_F(Sending, CallsByThatName) { EXPECT_EQ(result<double>("double", "arm.square.call(5)"), 25.0); }

TEST_F(Sending, WrongUses) {
    EXPECT_FALSE(run("var SendHandle h\nh.collect()"));
    EXPECT_EQ(messages(), "script.ops:2:1: error: [OPS148] nothing was sent with the handle 'h' before this line\n");
    EXPECT_FALSE(run("var SendHandle g\ng = 3"));
    EXPECT_EQ(messages(), "script.ops:2:5: error: [OPS149] expected 'operation.send(...)' for the handle 'g'\n");
    EXPECT_FALSE(run("var int n\nn.collect()"));
    EXPECT_EQ(messages(), "script.ops:2:1: error: [OPS147] expected a SendHandle before '.collect', 'n' is none\n");
    EXPECT_FALSE(run("var SendHandle k\nk = arm.square.send(1)\nk = arm.halve.send(n)"));
    EXPECT_NE(messages().find("OPS"), std::string::npos);
    EXPECT_FALSE(run("var SendHandle m\nm = arm.square.send(1)\nvar double a\nm.collect(a, a)"));
    EXPECT_EQ(messages(),
              "script.ops:4:1: error: [OPS142] 'm.collect' expects 1 argument or none, found 2 arguments\n");
}
