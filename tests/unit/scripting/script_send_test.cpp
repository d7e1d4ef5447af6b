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
        arm.addOperation(
            "twice", [](double x) { return 2 * x; }, OwnThread);
        arm.addOperation("note", [this](double x) { noted.push_back(x); });
        component.connectPeers(&arm);
        arm.start();
    }
    ~Sending() override { arm.stop(); }

    TaskContext arm;
    std::vector<double> noted;
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

TEST_F(Sending, AHandleMayBelongToAnotherOperationLater) {
    ASSERT_TRUE(run(
        "var SendHandle h\nvar double y\nh = arm.square.send(3)\nvar SendStatus one = h.collect(y)\nvar double a = y\n"
        "h = arm.halve.send(a)\nvar SendStatus two = h.collect(y)\n"
        "h = arm.square.send(5)\nvar double z\nvar SendStatus three = h.collect(z)"))
        << messages();
    EXPECT_EQ(value<double>("a"), 9.0);
    EXPECT_EQ(value<double>("y"), 4.5);
    EXPECT_EQ(value<double>("z"), 25.0);
    for (const char* status : {"one", "two", "three"}) EXPECT_EQ(value<SendStatus>(status), SendSuccess) << status;
}

TEST_F(Sending, WhatCollectsAHandleTakesTheOperationThatWasSentLast) {
    ASSERT_TRUE(
        run("program p {\n  var SendHandle h\n  var double y\n  var int sent = 0\n  while sent < 2 {\n"
            "    if sent == 1 then h = arm.square.send(3) else h = arm.twice.send(3)\n"
            "    h.collect(y)\n    arm.note(y)\n    sent = sent + 1\n  }\n}"))
        << messages();
    EXPECT_EQ(noted, (std::vector<double>{6.0, 9.0})) << "of the same signature: with variables";
    ASSERT_TRUE(
        run("var SendStatus any\nvar SendHandle g\nvar double h1 = 1\n"
            "if 1 == 1 then g = arm.square.send(3) else g = arm.halve.send(h1)\nany = g.collect()"))
        << messages();
    EXPECT_EQ(value<SendStatus>("any"), SendSuccess) << "of another one: without";
}

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
