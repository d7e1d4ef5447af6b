// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Scripts in the program as a user runs it.
#include "deployer_program.hpp"

#include <gmock/gmock.h>

namespace {

using namespace oroforge::test;
using testing::HasSubstr;
using testing::Not;

const char* const kApplication = R"(# A producer with a thread of its own, and who listens to it.
import("deploytest")
loadComponent("producer", "deploytest::Producer")
loadComponent("consumer", "deploytest::Consumer")
setActivity("producer", 0.01, 0, ORO_SCHED_OTHER)
var ConnPolicy wire
wire.type = BUFFER
wire.size = 100
connect("producer.numbers", "consumer.numbers", wire)
producer.first = 41
producer.configure
consumer.start()
producer.start()
)";

class DeployerScripts : public deployer_test::DeployerInDirectory {
protected:
    /** Runs a deployer whose component Application executes that text, to which it is to add its own end. */
    void expectShutdownBy(const std::string& definition) {
        directory_.write("app.ops",
                         "import(\"deploytest\")\n"
                         "loadComponent(\"Application\", \"deploytest::Consumer\")\n"
                         "setActivity(\"Application\", 0.01, 0, ORO_SCHED_OTHER)\n"
                         "loadService(\"Application\", \"scripting\")\n"
                         "loadComponent(\"other\", \"deploytest::Consumer\")\n"
                         "addPeer(\"Application\", \"other\")\n"
                         "Application.scripting.eval(\"" +
                             definition +
                             "\")\n"
                             "Application.start()\n");
        const Outcome outcome = runUntil("Application: started", {"-s", "app.ops"}, SIGTERM);
        EXPECT_EQ(0, outcome.status) << outcome.err;
        EXPECT_THAT(outcome.out, HasSubstr("other: started\nother: stopped\nApplication: stopped\n"));
    }
};

TEST_F(DeployerScripts, DeployAnApplication) {
    directory_.write("app.ops", kApplication);
    const Outcome outcome = runUntil("consumer: ten numbers in a row", {"-s", "app.ops"}, SIGTERM);
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("consumer: first number 41"));
    EXPECT_THAT(outcome.out, Not(HasSubstr("lost")));
    EXPECT_THAT(outcome.out, HasSubstr("consumer: stopped\nproducer: stopped\n"));
    EXPECT_THAT(outcome.out, HasSubstr("producer: deleted\n"));
}

TEST_F(DeployerScripts, StopAtTheFirstStatementThatCannotBeExecuted) {
    directory_.write("app.ops",
                     "import(\"deploytest\")\nloadComponent(\"c\", \"deploytest::Consumer\")\nc.strat()\nc.start()\n");
    const Outcome outcome = run(command({"-s", "app.ops"}));
    EXPECT_EQ(255, outcome.status);
    EXPECT_THAT(outcome.err,
                HasSubstr("app.ops:3:3: error: [OPS134] component 'c' has no operation 'strat'; did you mean "
                          "'start'?\nc.strat()\n  ^\n"));
    EXPECT_EQ("c: created\nc: cleaned up\nc: deleted\n", outcome.out);
}

TEST_F(DeployerScripts, AreCheckedWithoutBeingRun) {
    directory_.write("app.ops", kApplication);
    const Outcome good = run(command({"--check", "-s", "app.ops"}));
    EXPECT_EQ(0, good.status) << good.err;
    EXPECT_EQ("producer: created\nconsumer: created\nconsumer: cleaned up\nconsumer: deleted\nproducer: deleted\n",
              good.out);
    directory_.write("bad.ops", "import(ConnPolicy())\nloadComponent(\"c\")\nc.start()\nsetActivity(\"c\", 0.01, 0)\n");
    const Outcome bad = run(command({"--check", "-s", "bad.ops"}));
    EXPECT_EQ(255, bad.status);
    EXPECT_THAT(bad.err, HasSubstr("bad.ops:1:8: error: [OPS143]"));
    EXPECT_THAT(bad.err, HasSubstr("bad.ops:2:1: error: [OPS142]"));
    EXPECT_THAT(bad.err, HasSubstr("bad.ops:4:1: error: [OPS142]"));
    EXPECT_THAT(bad.err, Not(HasSubstr("bad.ops:3:")));
}

TEST_F(DeployerScripts, OperationsForScriptsAreKnownWhereTheyAreOnlyChecked) {
    directory_.write("app.ops",
                     "program p { nothing }\nunloadProgram(\"p\")\neval(\"var int a = 1\")\nrunScript(\"c.ops\")\n");
    directory_.write("b.ops", "eval(1, 2)\n");
    directory_.write("c.ops", "eval(\"\")\n");
    for (const char* option : {"--check", "--dry-run"}) {
        const Outcome good = run(command({option, "-s", "app.ops"}));
        EXPECT_EQ(0, good.status) << good.err;
        EXPECT_THAT(good.err, Not(HasSubstr("error")));
        const Outcome bad = run(command({option, "-s", "b.ops"}));
        EXPECT_EQ(255, bad.status);
        EXPECT_THAT(bad.err, HasSubstr("b.ops:1:1: error: [OPS142]"));
    }
}

TEST_F(DeployerScripts, AreRunByElementsOfXmlFiles) {
    directory_.write("values.ops", "first = 7\nprogram again { first = 8 }\n");
    directory_.write("program.ops", "program opener { consumer.start() }\n");
    directory_.write("machine.osd",
                     "StateMachine Watch { initial state idle { entry { opener.start() } } final state end { } }\n"
                     "RootMachine Watch watch\n");
    directory_.write("begin.ops", "consumer.watch.activate()\nproducer.start()\n");
    directory_.write("app.xml", R"(<properties>
  <simple name="Import" type="string"><value>deploytest</value></simple>
  <struct name="wire" type="ConnPolicy"><simple name="type" type="short"><value>1</value></simple>
    <simple name="size" type="short"><value>100</value></simple></struct>
  <struct name="producer" type="deploytest::Producer">
    <struct name="Activity" type="Activity"><simple name="Period" type="double"><value>0.01</value></simple>
      <simple name="Priority" type="short"><value>0</value></simple>
      <simple name="Scheduler" type="string"><value>ORO_SCHED_OTHER</value></simple></struct>
    <struct name="Ports" type="PropertyBag"><simple name="numbers" type="string"><value>wire</value></simple></struct>
    <simple name="RunScript" type="string"><value>values.ops</value></simple>
    <simple name="AutoConf" type="boolean"><value>1</value></simple>
  </struct>
  <struct name="consumer" type="deploytest::Consumer">
    <struct name="Activity" type="Activity"><simple name="Period" type="double"><value>0.01</value></simple>
      <simple name="Priority" type="short"><value>0</value></simple>
      <simple name="Scheduler" type="string"><value>ORO_SCHED_OTHER</value></simple></struct>
    <struct name="Ports" type="PropertyBag"><simple name="numbers" type="string"><value>wire</value></simple></struct>
    <simple name="ProgramScript" type="string"><value>program.ops</value></simple>
    <simple name="StateMachineScript" type="string"><value>machine.osd</value></simple>
  </struct>
</properties>
)");
    const Outcome outcome = runUntil("consumer: ten numbers in a row", {"-s", "app.xml", "begin.ops"}, SIGTERM);
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("consumer: started"));
    EXPECT_THAT(outcome.out, HasSubstr("consumer: first number 7"));
}

TEST_F(DeployerScripts, MayConfigureAndStartTheComponentThatTheFileHasConfiguredAndStarted) {
    for (const std::string script : {"configure()\n", "configure()\nstart()\n"}) {
        directory_.write("up.ops", script);
        directory_.write("app.xml", R"(<properties>
  <simple name="Import" type="string"><value>deploytest</value></simple>
  <struct name="producer" type="deploytest::Producer">
    <simple name="RunScript" type="string"><value>up.ops</value></simple>
    <simple name="AutoConf" type="boolean"><value>1</value></simple>
    <simple name="AutoStart" type="boolean"><value>1</value></simple>
  </struct>
</properties>
)");
        const Outcome outcome = run(command({"-s", "app.xml"}));
        EXPECT_EQ(0, outcome.status) << script << outcome.err;
        EXPECT_THAT(outcome.out, HasSubstr("producer: started")) << outcome.err;
    }
}

TEST_F(DeployerScripts, MayConfigureAndStartAnotherComponentThatItsFileConfiguresAndStarts) {
    const std::string options = R"(
    <simple name="AutoConf" type="boolean"><value>1</value></simple>
    <simple name="AutoStart" type="boolean"><value>1</value></simple>
  </struct>
)";
    const std::string producer = R"(<struct name="producer" type="deploytest::Producer">)" + options;
    const std::string consumer = R"(<struct name="consumer" type="deploytest::Consumer">
    <struct name="Peers" type="PropertyBag"><simple type="string"><value>producer</value></simple></struct>
    <simple name="RunScript" type="string"><value>up.ops</value></simple>)" +
                                 options;
    const auto file = [](const std::string& components) {
        return R"(<properties><simple name="Import" type="string"><value>deploytest</value></simple>)" + components +
               "</properties>\n";
    };
    directory_.write("again.xml", file(producer));
    for (const std::string script : {"producer.configure()\n", "producer.configure()\nproducer.start()\n"})
        for (const std::string& components : {consumer + producer, producer + consumer}) {
            directory_.write("up.ops", script);
            directory_.write("app.xml", file(components));
            const Outcome outcome = run(command({"-s", "app.xml", "again.xml"}));
            EXPECT_EQ(0, outcome.status) << script << components << outcome.err;
            EXPECT_THAT(outcome.out, HasSubstr("producer: started")) << outcome.err;
            EXPECT_THAT(outcome.out, HasSubstr("consumer: started")) << outcome.err;
        }
}

TEST_F(DeployerScripts, TakeTheApplicationDownByItsProgram) {
    expectShutdownBy("program shutdownDeployment { other.start()\\n yield\\n other.stop() }");
}

TEST_F(DeployerScripts, TakeTheApplicationDownByItsFunction) {
    expectShutdownBy("export void shutdownDeployment() { other.start()\\n other.stop() }");
}

TEST_F(DeployerScripts, TakeDownTheComponentAndForTheTimeThatPropertiesOfTheDeployerName) {
    directory_.write("app.xml", R"(<properties>
  <simple name="Import" type="string"><value>deploytest</value></simple>
  <struct name="this" type="PropertyBag"><struct name="Properties" type="PropertyBag">
    <simple name="shutdownPeer" type="string"><value>boss</value></simple>
    <simple name="shutdownTotalWait_ms" type="long"><value>90</value></simple>
    <simple name="shutdownWait_ms" type="long"><value>0</value></simple>
  </struct></struct>
  <struct name="boss" type="deploytest::Consumer">
    <struct name="Activity" type="Activity"><simple name="Period" type="double"><value>0.01</value></simple></struct>
    <simple name="ProgramScript" type="string"><value>end.ops</value></simple>
    <simple name="AutoStart" type="boolean"><value>1</value></simple>
  </struct>
</properties>
)");
    directory_.write("end.ops", "program shutdownDeployment { while (true) { yield } }\n");
    const Outcome outcome = runUntil("boss: started", {"-s", "app.xml"}, SIGTERM);
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("component 'boss' did not end its shutdown within 90 ms"));
    EXPECT_THAT(
        outcome.err,
        HasSubstr("'shutdownWait_ms' of the deployer has type int and value 0, expected an int above 0; 50 is used"));
}

}  // namespace
