// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Chains in the deployer: scripts, files, checks, reports.
#include "../deployer/deployer_program.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace {

using namespace oroforge::test;
using testing::HasSubstr;
using testing::Not;

std::string simple(const std::string& name, const std::string& value, const std::string& type = "string") {
    return "<simple name='" + name + "' type='" + type + "'><value>" + value + "</value></simple>\n";
}

std::string list(const std::string& name, const std::string& content, const std::string& type = "PropertyBag") {
    return "<struct name='" + name + "' type='" + type + "'>\n" + content + "</struct>\n";
}

std::string members(const std::vector<std::string>& names) {
    std::string all;
    for (const std::string& name : names) all += simple("m", name);
    return list("Members", all);
}

std::string activity(const std::string& period) {
    return list(
        "Activity",
        simple("Period", period, "double") + simple("Priority", "0", "short") + simple("Scheduler", "ORO_SCHED_OTHER"),
        "Activity");
}

std::string document(const std::string& content) { return "<properties>\n" + content + "</properties>\n"; }

const std::string kServices = "loadService(\"Deployer\", \"os\")\nloadService(\"Deployer\", \"print\")\n";

class ChainProcess : public deployer_test::DeployerInDirectory {
protected:
    Outcome run(std::vector<std::string> words, const std::map<std::string, std::string>& files) {
        for (const auto& [name, text] : files) {
            directory_.write(name, text);
            words.push_back(name);
        }
        return ChildProcess(command(words)).finish();
    }
    Outcome script(const std::string& text) { return run({}, {{"app.ops", kServices + text}}); }
    std::string log() const { return readFile(directory_ / "orocos.log"); }
};

TEST_F(ChainProcess, HundredLuaSlavesOfFbsched) {
    std::string text =
        "import(\"fbsched\")\nloadComponent(\"s\", \"FBSched\")\n"
        "setActivity(\"s\", 0.01, 0, ORO_SCHED_OTHER)\n";
    for (int i = 100; i < 200; ++i) {
        const std::string name = "m" + std::to_string(i);
        text += "loadComponent(\"" + name + "\", \"OCL::LuaComponent\")\n" + name +
                ".exec_str(\"n = 0 function updateHook() n = n + 1 end\")\nsetMasterSlaveActivity(\"s\", \"" + name +
                "\")\n" + name + ".configure()\n" + name + ".start()\n";
    }
    text +=
        "s.sched_order = strings(\"m107\", \"m103\", "
        "\"m199\")\ns.start()\nos.sleep(1)\ns.displaySchedList()\ns.stop()\n";
    for (int i = 100; i < 200; ++i) text += "m" + std::to_string(i) + ".exec_str(\"print('count', n)\")\n";
    const Outcome outcome = script(text);
    EXPECT_EQ(0, outcome.status) << outcome.err << log();
    EXPECT_THAT(outcome.out, HasSubstr("Order of s:\n  m107\n  m103\n  m199\n  m100\n  m101\n"));
    std::vector<int> counts;
    std::istringstream lines(outcome.out);
    for (std::string line; std::getline(lines, line);)
        if (line.compare(0, 5, "count") == 0) counts.push_back(std::atoi(line.c_str() + 5));
    ASSERT_EQ(100u, counts.size());
    const auto [least, most] = std::minmax_element(counts.begin(), counts.end());
    EXPECT_EQ(*least, *most);
    EXPECT_LT(20, *least);
}

TEST_F(ChainProcess, MadeByOneOperation) {
    const Outcome outcome = script(
        "loadComponent(\"a\", \"TaskContext\")\nloadComponent(\"b\", \"TaskContext\")\n"
        "if chain(\"c\", 0.01, 0, ORO_SCHED_OTHER, strings(\"b\", \"a\")) then print.ln(\"made\")\n"
        "a.start()\nb.start()\nc.start()\nos.millisleep(100)\nc.displaySchedList()\n"
        "kickOutComponent(\"c\")\nif a.isRunning() then print.ln(\"runs\") else print.ln(\"stopped\")\n");
    EXPECT_EQ(0, outcome.status) << outcome.err << log();
    EXPECT_THAT(outcome.out, HasSubstr("made"));
    EXPECT_THAT(outcome.out, HasSubstr("Order of c:\n  b\n  a\n"));
    EXPECT_THAT(outcome.out, HasSubstr("stopped"));
    EXPECT_THAT(log(), HasSubstr("component 'a' is stopped: its master 'c' is being deleted"));
}

TEST_F(ChainProcess, TheOperationSaysWhyNot) {
    const Outcome outcome = script(
        "loadComponent(\"a\", \"TaskContext\")\n"
        "var bool x = chain(\"c\", 0.01, 0, ORO_SCHED_OTHER, strings(\"a\", \"b\"))\n"
        "x = chain(\"a\", 0.01, 0, ORO_SCHED_OTHER, strings(\"b\"))\n"
        "if loadComponent(\"c\", \"TaskContext\") then print.ln(\"gone\")\n");
    EXPECT_THAT(log(), HasSubstr("could not make chain 'c': there is no component 'b'"));
    EXPECT_THAT(log(), HasSubstr("could not make chain 'a': component 'a' is no chain"));
    EXPECT_THAT(outcome.out, HasSubstr("gone"));
}

TEST_F(ChainProcess, TheDeployerIsAMaster) {
    const Outcome outcome = script(
        "loadComponent(\"a\", \"TaskContext\")\n"
        "if setMasterSlaveActivity(\"this\", \"a\") then print.ln(\"slave\")\n"
        "if a.start() then print.ln(\"started\")\n"
        "loadComponent(\"c\", \"OCL::Chain\")\nloadComponent(\"b\", \"TaskContext\")\n"
        "setMasterSlaveActivity(\"c\", \"b\")\nsetActivity(\"c\", 0.005, 0, ORO_SCHED_OTHER)\n"
        "if b.start() && c.start() then print.ln(\"attached again\")\n");
    EXPECT_EQ(0, outcome.status) << outcome.err << log();
    for (const char* part : {"slave", "started", "attached again"}) EXPECT_THAT(outcome.out, HasSubstr(part));
}

TEST_F(ChainProcess, PropertyFilesWrittenForOclAreComplete) {
    const auto from = [](const char* file) { return simple("PropertyFile", file); };
    std::string flags;
    for (const char* name : {"WriteHeader", "Decompose", "Snapshot", "Synchronize", "ReportOnlyNewData"})
        flags += simple(name, "1", "boolean");
    const std::map<std::string, std::string> files = {
        {"s.cpf", document(list("sched_order", simple("0", "b") + simple("1", "a"), "strings"))},
        {"r.cpf",
         document(flags + list("ReportData", "") + list("ReportPolicy", simple("size", "3", "long"), "ConnPolicy") +
                  simple("port", "0", "ulong"))},
        {"none.cpf", document(simple("manage", "1", "boolean"))}};
    for (const auto& [name, text] : files) directory_.write(name, text);
    Outcome outcome = run(
        {}, {{"app.xml", document(list("s", from("s.cpf"), "FBSched") + list("r", from("r.cpf"), "OCL::TcpReporting"))},
             {"then.ops", kServices + "print.ln(s.sched_order[0] + s.on_error + r.ReportPolicy.size)\n"}});
    EXPECT_EQ(0, outcome.status) << outcome.err << log();
    EXPECT_THAT(outcome.out, HasSubstr("bskip3\n"));
    outcome = run({}, {{"app.xml", document(list("s", from("none.cpf"), "FBSched"))}});
    EXPECT_EQ(255, outcome.status);
    EXPECT_THAT(outcome.err, HasSubstr("property 'sched_order' of type strings is missing"));
}

TEST_F(ChainProcess, DescribedInAFile) {
    const std::string start = simple("AutoConf", "1", "boolean") + simple("AutoStart", "1", "boolean");
    const std::string text =
        document(list("c", activity("0.01") + members({"y", "inner", "x"}) + start, "OCL::Chain") +
                 list("inner", members({"z"}) + start, "OCL::Chain") + list("x", start, "TaskContext") +
                 list("y", start, "TaskContext") + list("z", start, "TaskContext") +
                 list("reporter",
                      activity("0.02") + start + list("Peers", simple("p", "c")) +
                          list("Properties",
                               simple("ReportFile", "report.dat") +
                                   list("ReportData", simple("Port", "c.statistics") + simple("Port", "c.iteration"))),
                      "OCL::FileReporting"));
    Outcome outcome = run(
        {},
        {{"app.xml", text}, {"then.ops", kServices + "os.sleep(1)\nc.displaySchedList()\nprint.ln(c.timeReport())\n"}});
    EXPECT_EQ(0, outcome.status) << outcome.err << log();
    EXPECT_THAT(outcome.out, HasSubstr("Order of c:\n  y\n  inner\n  x\n"));
    EXPECT_THAT(outcome.out, HasSubstr("chain 'inner', "));
    const std::string report = readFile(directory_ / "report.dat");
    for (const char* column : {"c.statistics.cycle.mean", "c.statistics.members.1.times.p999", "c.iteration"})
        EXPECT_THAT(report.substr(0, report.find('\n')), HasSubstr(column));
    EXPECT_LT(5, std::count(report.begin(), report.end(), '\n'));

    outcome = run({"--check"}, {{"app.xml", text}});
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("chain 'c': thread 'c', ORO_SCHED_OTHER, priority 0, period 0.01 s\n"
                                       "  1 y\n  2 inner\n  3 x\n"));
    EXPECT_THAT(outcome.out, Not(HasSubstr("error")));
    outcome = run({"--dry-run"}, {{"app.xml", text}});
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("chain 'c': Activity, ORO_SCHED_OTHER, priority 0, period 0.01 s\n"
                                       "  1 y\n  2 inner\n  3 x\n"));
    EXPECT_THAT(outcome.out, HasSubstr("chain 'inner': in the thread of 'c'\n  1 z\n"));
}

TEST_F(ChainProcess, FaultsInAFile) {
    const std::string text = document(list("c", members({"a", "nobody", "a", "c", "own"}), "OCL::Chain") +
                                      list("d", members({"a"}), "OCL::Chain") + list("a", "", "TaskContext") +
                                      list("own", activity("0.1"), "TaskContext"));
    const Outcome outcome = run({"--dry-run"}, {{"app.xml", text}});
    EXPECT_NE(0, outcome.status);
    for (const char* part :
         {"[DEP016] member 'nobody' of chain 'c' does not exist", "[DEP017] chain 'c' is its own member",
          "[DEP013] component 'a' is a member of chain 'c', and of another or for a second time",
          "[DEP013] component 'a' is a member of chain 'd', and of another",
          "[DEP013] component 'own' is a member of chain 'c', which executes it, but has an Activity"})
        EXPECT_THAT(outcome.err, HasSubstr(part));
    const Outcome other =
        run({"--check"},
            {{"other.xml", document(list("a", members({"b"}), "TaskContext") + list("b", "", "TaskContext"))}});
    EXPECT_THAT(other.err, HasSubstr("[DEP054] component 'a' is no chain"));
}

TEST_F(ChainProcess, ACheckShowsTheChainsOfAScript) {
    const std::string text = kServices +
                             "import(\"ocl\")\nloadComponent(\"a\", \"OCL::HelloWorld\")\n"
                             "loadComponent(\"b\", \"OCL::HelloWorld\")\nloadComponent(\"c\", \"OCL::HelloWorld\")\n"
                             "connect(\"a.the_results\", \"b.the_buffer_port\", ConnPolicy())\n"
                             "connect(\"b.the_results\", \"a.the_buffer_port\", ConnPolicy())\n"
                             "chain(\"servo\", 0.02, -3, ORO_SCHED_OTHER, strings(\"a\", \"b\"))\n"
                             "loadComponent(\"loop\", \"OCL::Chain\")\n"
                             "setActivity(\"loop\", 0.0, 5, ORO_SCHED_RT)\n"
                             "setMasterSlaveActivity(\"loop\", \"c\")\n"
                             "var strings names = strings(\"c\")\nvar double period = 0.1\n"
                             "if os.argc() > 99 then chain(\"other\", period, 0, 0, names)\n";
    const Outcome outcome = run({"--check"}, {{"app.ops", text}});
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_EQ(
        "chain 'servo' made in app.ops:9: ORO_SCHED_OTHER, priority -3, period 0.02 s\n  1 a\n  2 b\n"
        "  one cycle late: b.the_results → a.the_buffer_port\n"
        "chain 'other', perhaps made in app.ops:15: a scheduler that the script computes, priority 0, a period that "
        "the script computes\n  the script computes the members\n"
        "chain 'loop' made in app.ops:10: ORO_SCHED_RT, priority 5, not periodic\n  1 c\n"
        "  in this order unless the property sched_order says otherwise\n",
        outcome.out);
    // A script that runs makes its chains, so that there is nothing to foresee.
    EXPECT_THAT(script(text).out, Not(HasSubstr("made in")));
}

TEST_F(ChainProcess, TheRealTimeCheckNamesTheMember) {
    const std::string text = document(
        list("c",
             list("Activity",
                  simple("Period", "0.001", "double") + simple("Priority", "10", "short") +
                      simple("Scheduler", "ORO_SCHED_RT"),
                  "Activity") +
                 members({"still", "noisy"}) + simple("AutoStart", "1", "boolean"),
             "OCL::Chain") +
        list("still", simple("AutoStart", "1", "boolean"), "TaskContext") +
        list("noisy", simple("AutoStart", "1", "boolean") + simple("AutoConf", "1", "boolean"), "OCL::HelloWorld"));
    directory_.write("app.xml", text);
    directory_.write("then.ops", kServices + "noisy.flag = true\nos.millisleep(500)\n");
    const Outcome outcome = ChildProcess(command({"--rt-check", "app.xml", "then.ops"})).finish();
    if (outcome.err.find("saw no updateHook()") != std::string::npos)
        GTEST_SKIP() << "this process may not have real-time threads";
    EXPECT_THAT(outcome.err, HasSubstr("noisy"));
    EXPECT_THAT(outcome.err, Not(HasSubstr("'c'"))) << outcome.err;
    EXPECT_THAT(outcome.err, Not(HasSubstr("still")));
}

}  // namespace
