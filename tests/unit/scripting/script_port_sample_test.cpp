// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Members of what an operation gives that is called without parentheses: of the last sample of an output port, above all.
#include "../types/sample_types.hpp"
#include "script_fixture.hpp"

#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>

#include <gmock/gmock.h>

using namespace RTT;

namespace {

class PortSamples : public ScriptTest {
protected:
    PortSamples() : traj("traj"), plan("plan") {
        sample::addTypes();
        traj.addPort(cmd);
        traj.addPort(in);
        traj.provides("arm")->addPort(tip);
        plan.addPort(goal);
        traj.addOperation("filled", &PortSamples::filled, this);
        traj.addOperation("write", &PortSamples::write, this).arg("id", "");
        component.addAttribute("sum", sum);
        component.addOperation("add", &PortSamples::add, this).arg("a", "").arg("b", "");
        component.addOperation("change", &PortSamples::change, this).arg("value", "");
        component.connectPeers(&traj);
        traj.addPeer(&plan);
    }

    static sample::Tank tankOf(int id) {
        sample::Tank tank;
        tank.id = id;
        tank.label = "tank " + std::to_string(id);
        tank.position = {id + 0.5, id * 2.0};
        tank.levels = {id * 1.0, id * 10.0};
        tank.path = {{1, 2}, {id * 1.0, 4}};
        tank.weights[1] = id * 100.0;
        tank.pair = {{id, -id}};
        return tank;
    }
    sample::Tank filled() { return tankOf(++calls); }
    void write(int id) { cmd.write(tankOf(id)); }
    double add(double a, double b) { return a + b; }
    void change(double& value) { value = 1; }

    TaskContext traj, plan;
    OutputPort<sample::Tank> cmd{"cmd"}, tip{"tip"}, own{"own"};
    OutputPort<int> goal{"goal"};
    InputPort<sample::Tank> in{"in"};
    int calls = 0;
    double sum = 0;
};

}  // namespace

TEST_F(PortSamples, AMemberOfTheLastSampleOfAPortIsAValue) {
    cmd.write(tankOf(3));
    EXPECT_EQ(result<int>("int", "traj.cmd.last.id"), 3);
    EXPECT_EQ(result<double>("double", "traj.cmd.last.position.x"), 3.5);
    EXPECT_EQ(result<double>("double", "traj.cmd.last.position.y * 2 + 1"), 13);
    EXPECT_EQ(result<std::string>("string", "traj.cmd.last.label"), "tank 3");
    EXPECT_EQ(result<int>("int", "traj.cmd.last.label.size"), 6);
    EXPECT_EQ(result<double>("double", "traj.cmd.last().position.x"), 3.5);
}

TEST_F(PortSamples, ElementsOfItsSequencesAndArraysAreValues) {
    cmd.write(tankOf(3));
    EXPECT_EQ(result<int>("int", "traj.cmd.last.levels.size"), 2);
    EXPECT_EQ(result<double>("double", "traj.cmd.last.levels[1]"), 30);
    EXPECT_EQ(result<double>("double", "traj.cmd.last.path[1].x"), 3);
    EXPECT_EQ(result<double>("double", "traj.cmd.last.weights[1]"), 300);
    EXPECT_EQ(result<int>("int", "traj.cmd.last.weights.size"), 3);
    EXPECT_EQ(result<int>("int", "traj.cmd.last.pair[1]"), -3);
    EXPECT_EQ(result<double>("double", "traj.cmd.last.levels[7]"), 0) << "there is none";
}

TEST_F(PortSamples, AreReadWheneverTheStatementIsExecuted) {
    ASSERT_TRUE(
        run("var int i\n"
            "while i < 3 {\n"
            "  i = i + 1\n"
            "  traj.write(i)\n"
            "  if traj.cmd.last.weights[1] == i * 100.0 then sum = sum + traj.cmd.last.path[1].x\n"
            "  sum = add(sum, traj.cmd.last.pair[0])\n"
            "}"))
        << messages();
    EXPECT_EQ(sum, 12);
}

TEST_F(PortSamples, AreDefaultValuesUntilOneWasWritten) {
    ASSERT_TRUE(
        run("var double x = traj.cmd.last.position.x, w = traj.cmd.last.weights[1]\n"
            "var int n = traj.cmd.last.levels.size\n"
            "var double none = traj.cmd.last.levels[0], p = traj.cmd.last.path[1].y"))
        << messages();
    for (const char* const name : {"x", "w", "none", "p"}) EXPECT_EQ(value<double>(name), 0) << name;
    EXPECT_EQ(value<int>("n"), 0);
}

TEST_F(PortSamples, OfServicesAndPeersOfPeers) {
    tip.write(tankOf(4));
    goal.write(7);
    EXPECT_EQ(result<double>("double", "traj.arm.tip.last.position.x"), 4.5);
    EXPECT_EQ(result<int>("int", "traj.plan.goal.last"), 7);
    component.addPort(own);
    own.write(tankOf(2));
    EXPECT_EQ(result<int>("int", "own.last.id"), 2);
    EXPECT_EQ(result<int>("int", "this.own.last.pair[0]"), 2);
    EXPECT_EQ(result<int>("int", "own.name.size"), 3) << "other operations, too";
}

TEST_F(PortSamples, AsAliasesAndInFunctionsAndPrograms) {
    cmd.write(tankOf(3));
    ASSERT_TRUE(
        run("alias double height = traj.cmd.last.weights[1]\n"
            "double heightOf() { return traj.cmd.last.weights[1] }\n"
            "program p { sum = height + heightOf() }"))
        << messages();
    EXPECT_EQ(sum, 600);
}

TEST_F(PortSamples, AreNotChanged) {
    cmd.write(tankOf(3));
    const char* const refused =
        "script.ops:1:1: error: [OPS127] this is a constant or a result and cannot be assigned to\n";
    for (const char* const member : {"id", "position.x", "levels[0]", "path[0].x", "weights[1]", "pair[0]", "label"}) {
        EXPECT_FALSE(run(std::string("traj.cmd.last.") + member + " = traj.cmd.last." + member)) << member;
        EXPECT_EQ(messages(), refused) << member;
    }
    EXPECT_FALSE(run("change(traj.cmd.last.position.x)"));
    EXPECT_EQ(messages(),
              "script.ops:1:8: error: [OPS144] argument 1 of 'change' is assigned by the call: expected a variable, "
              "found a value of type double\n");
    EXPECT_FALSE(run("change(traj.cmd.last.weights[1])"));
    EXPECT_EQ(cmd.getLastWrittenValue().weights[1], 300);
}

TEST_F(PortSamples, UnknownMembersAndPortsWithoutLastSampleAreErrors) {
    EXPECT_FALSE(run("sum = traj.cmd.last.position.z"));
    EXPECT_EQ(messages(), "script.ops:1:30: error: [OPS123] type /sample/Point has no member 'z'\n");
    EXPECT_FALSE(run("sum = traj.cmd.last.position.x.y"));
    EXPECT_EQ(messages(), "script.ops:1:32: error: [OPS123] type double has no member 'y'\n");
    EXPECT_FALSE(run("sum = traj.cmd.lst.id"));
    EXPECT_EQ(messages(),
              "script.ops:1:16: error: [OPS133] service 'traj.cmd' has no peer, service or value 'lst'; did you mean "
              "'last'?\n");
    EXPECT_FALSE(run("sum = traj.in.last.id"));
    EXPECT_EQ(messages(), "script.ops:1:15: error: [OPS133] service 'traj.in' has no peer, service or value 'last'\n");
    EXPECT_FALSE(run("sum = traj.write.id"));
    EXPECT_THAT(messages(), testing::StartsWith("script.ops:1:7: error: [OPS142] 'traj.write' expects 1 argument"));
    EXPECT_FALSE(run("traj.cmd.last.clear()"));
    EXPECT_EQ(messages(),
              "script.ops:1:15: error: [OPS134] 'traj.cmd.last' is a value of type /sample/Tank and has no operation "
              "'clear'\n");
    EXPECT_FALSE(run("traj.cmd.connected.size = 1"));
}

TEST_F(PortSamples, OperationsWithoutParenthesesGiveMembersToo) {
    EXPECT_EQ(result<int>("int", "traj.filled.id"), 1);
    EXPECT_EQ(result<double>("double", "traj.filled.weights[1]"), 200) << "called once, when it is executed";
    EXPECT_EQ(result<double>("double", "traj.filled().weights[1]"), 300);
    EXPECT_EQ(calls, 3);
    ASSERT_TRUE(run("string nameOfIt() { return \"abc\" }\nvar int length = nameOfIt.size")) << messages();
    EXPECT_EQ(value<int>("length"), 3);
}
