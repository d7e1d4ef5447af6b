// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a check must not do, what site files and signals do to the program's end.
#include "deployer_program.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <thread>

namespace {

using namespace oroforge::test;
using testing::HasSubstr;
using testing::Not;

/** A consumer that is started with its application, by its own script and by that of the deployer. */
const char* const kEager = R"(<properties>
  <simple name="Import" type="string"><value>deploytest</value></simple>
  <struct name="one" type="deploytest::Consumer">
    <simple name="AutoStart" type="boolean"><value>1</value></simple>
    <simple name="RunScript" type="string"><value>one.ops</value></simple>
  </struct>
  <struct name="two" type="deploytest::Consumer"/>
  <struct name="this" type="PropertyBag">
    <simple name="RunScript" type="string"><value>all.ops</value></simple>
  </struct>
</properties>
)";

const char* const kBad = "<properties>\n<struct name=\"a\" type=\"no::Such\"/>\n</properties>\n";

class DeployerCheck : public deployer_test::DeployerInDirectory {
protected:
    DeployerCheck() {
        directory_.write("app.xml", kEager);
        directory_.write("one.ops", "start()\n");
        directory_.write("all.ops",
                         "startComponent(\"two\")\ntwo.start()\nstartComponents()\nstart()\n"
                         "loadComponent(\"three\", \"deploytest::Consumer\")\nthree.start()\n");
    }
};

TEST_F(DeployerCheck, StartsNothingWhateverScriptsSay) {
    const Outcome check = run(command({"--check", "-s", "app.xml"}));
    EXPECT_EQ(0, check.status) << check.err;
    EXPECT_THAT(check.out, HasSubstr("three: created"));
    EXPECT_THAT(check.out, Not(HasSubstr("started")));
    Command program = command({"-s", "app.xml"});
    program.program = RTTSCRIPT_PROGRAM;
    const Outcome deployed = run(program);
    EXPECT_EQ(0, deployed.status) << deployed.err;
    for (const char* name : {"one", "two", "three"})
        EXPECT_THAT(deployed.out, HasSubstr(std::string(name) + ": started"));
}

TEST_F(DeployerCheck, StopsWhatTheCodeOfComponentsStarts) {
    directory_.write("app.xml", R"(<properties>
  <simple name="Import" type="string"><value>deploytest</value></simple>
  <struct name="e" type="deploytest::Eager">
    <simple name="AutoConf" type="boolean"><value>1</value></simple>
    <struct name="Peers" type="PropertyBag"><simple type="string"><value>c</value></simple></struct>
  </struct>
  <struct name="c" type="deploytest::Consumer"/>
</properties>
)");
    const Outcome check = run(command({"--check", "-s", "app.xml"}));
    EXPECT_EQ(0, check.status) << check.err;
    EXPECT_THAT(check.err, HasSubstr("app.xml:3:17: warning: [DEP059] component 'e' was started by"));
    EXPECT_THAT(check.err, HasSubstr("app.xml:7:17: warning: [DEP059] component 'c' was started by"));
    EXPECT_EQ(
        "e: created\ne: started\nc: created\ne: stopped\nc: started\ne: configured\nc: stopped\n"
        "c: cleaned up\ne: cleaned up\nc: deleted\ne: deleted\n",
        check.out);
    Command program = command({"-s", "app.xml"});
    program.program = RTTSCRIPT_PROGRAM;
    EXPECT_THAT(run(program).err, Not(HasSubstr("DEP059")));
}

TEST_F(DeployerCheck, StartsNothingOfTheSiteFile) {
    const Outcome check = run(command({"--check", "--site-file", "app.xml"}));
    EXPECT_EQ(0, check.status) << check.err;
    EXPECT_THAT(check.out, HasSubstr("three: created"));
    EXPECT_THAT(check.out, Not(HasSubstr("started")));
}

TEST_F(DeployerCheck, ASiteFileThatIsWrongIsAFailure) {
    directory_.write("Deployer-site.cpf", kBad);
    for (const char* option : {"--check", "--dry-run", "--no-consolelog"}) {
        const Outcome outcome = run(command({option, "-s", "app.xml"}));
        EXPECT_EQ(255, outcome.status) << option;
        EXPECT_THAT(outcome.err, HasSubstr("Deployer-site.cpf:2:24: error: [DEP031]"));
        EXPECT_THAT(outcome.out, Not(HasSubstr("created"))) << "files behind one that failed are not tried";
    }
}

TEST_F(DeployerCheck, ASiteFileThatWasAskedForIsMissed) {
    const Outcome named = run(command({"--check", "--site-file", "none.cpf"}));
    EXPECT_EQ(0, named.status);
    EXPECT_THAT(named.err, HasSubstr("there is no site file 'none.cpf'"));
    directory_.write("import.xml",
                     "<properties><simple name='Import' type='string'><value>deploytest</value></simple></properties>");
    EXPECT_EQ("", run(command({"--check", "import.xml"})).err);
}

TEST_F(DeployerCheck, ASignalWhileFilesAreDeployedEndsThatInOrder) {
    directory_.write("wait.ops",
                     "import(\"deploytest\")\nloadComponent(\"c\", \"deploytest::Consumer\")\nc.start()\n"
                     "if (!waitForSignal(10)) then c.stop()\n");
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
        ChildProcess deployer(lasting({"-s", "wait.ops", "-s", "app.xml"}));
        EXPECT_TRUE(deployer.waitForOutput("c: started", std::chrono::seconds(20)));
        deployer.send(signal);
        const Outcome outcome = deployer.finish();
        EXPECT_EQ(255, outcome.status) << "app.xml was not deployed";
        EXPECT_THAT(outcome.err, HasSubstr("wait.ops: a signal came that ends the program, after the present step; "));
        EXPECT_THAT(outcome.err, HasSubstr("app.xml: error: not deployed: a signal came that ends the program"));
        EXPECT_EQ("c: created\nc: started\nc: stopped\nc: cleaned up\nc: deleted\n", outcome.out);
    }
}

TEST_F(DeployerCheck, ASignalThatNohupHasIgnoredStaysIgnored) {
    directory_.write("go_on.ops",
                     "import(\"deploytest\")\nloadComponent(\"c\", \"deploytest::Consumer\")\nc.start()\n");
    Command program = lasting({});
    program.arguments = {"-c", "trap '' HUP; exec \"$0\" -s go_on.ops", program.program};
    program.program = "/bin/sh";
    ChildProcess deployer(program);
    EXPECT_TRUE(deployer.waitForOutput("c: started", std::chrono::seconds(20)));
    deployer.send(SIGHUP);
    EXPECT_FALSE(deployer.waitForOutput("c: stopped", std::chrono::milliseconds(300)));
    deployer.send(SIGTERM);
    EXPECT_EQ(0, deployer.finish().status);
}

TEST_F(DeployerCheck, ASignalBetweenStepsUndoesTheFile) {
    directory_.write("one.ops",
                     "Deployer.loadComponent(\"ready\", \"deploytest::Consumer\")\nDeployer.waitForSignal(10)\n");
    directory_.write("app.xml", R"(<properties>
  <simple name="Import" type="string"><value>deploytest</value></simple>
  <struct name="one" type="deploytest::Consumer">
    <struct name="Peers" type="PropertyBag"><simple type="string"><value>Deployer</value></simple></struct>
    <simple name="RunScript" type="string"><value>one.ops</value></simple>
    <simple name="AutoStart" type="boolean"><value>1</value></simple>
  </struct>
</properties>
)");
    ChildProcess deployer(lasting({"-s", "app.xml"}));
    EXPECT_TRUE(deployer.waitForOutput("ready: created", std::chrono::seconds(20)));
    deployer.send(SIGTERM);
    const Outcome outcome = deployer.finish();
    EXPECT_EQ(255, outcome.status);
    EXPECT_THAT(outcome.err, HasSubstr("signal 15 came while 'app.xml' was being deployed"));
    EXPECT_EQ("one: created\nready: created\none: cleaned up\none: deleted\nready: cleaned up\nready: deleted\n",
              outcome.out);
}

TEST_F(DeployerCheck, WhatASignalEndsIsStoppedInOrder) {
    directory_.write("wait.ops",
                     "import(\"deploytest\")\nloadComponent(\"c\", \"deploytest::Consumer\")\nc.start()\n"
                     "waitForSignal(10)\n");
    ChildProcess deployer(lasting({"-s", "wait.ops"}));
    EXPECT_TRUE(deployer.waitForOutput("c: started", std::chrono::seconds(20)));
    deployer.send(SIGTERM);
    const Outcome outcome = deployer.finish();
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_EQ("c: created\nc: started\nc: stopped\nc: cleaned up\nc: deleted\n", outcome.out);
}

TEST_F(DeployerCheck, AScriptThatDoesNotEndIsInterruptedSomeTimeAfterASignal) {
    directory_.write("loop.ops",
                     "import(\"deploytest\")\nloadComponent(\"c\", \"deploytest::Consumer\")\nc.start()\n"
                     "while (true) { c.isRunning() }\n");
    directory_.write("app.xml", R"(<properties>
  <simple name="Import" type="string"><value>deploytest</value></simple>
  <struct name="one" type="deploytest::Consumer">
    <struct name="Peers" type="PropertyBag"><simple type="string"><value>Deployer</value></simple></struct>
    <simple name="RunScript" type="string"><value>one.ops</value></simple>
  </struct>
</properties>
)");
    directory_.write("one.ops",
                     "Deployer.loadComponent(\"c\", \"deploytest::Consumer\")\nDeployer.c.start()\n"
                     "while (true) { Deployer.c.isRunning() }\n");
    const std::pair<const char*, const char*> cases[] = {
        {"-sloop.ops", "loop.ops:4:"}, {"-sapp.xml", "one.ops:3:"}, {"--site-file=app.xml", "one.ops:3:"}};
    for (const auto& [file, place] : cases) {
        ChildProcess deployer(lasting({file, "-s", "next.xml"}));
        EXPECT_TRUE(deployer.waitForOutput("c: started", std::chrono::seconds(20)));
        deployer.send(SIGINT);
        const Outcome outcome = deployer.finish();
        EXPECT_FALSE(outcome.timedOut);
        EXPECT_EQ(255, outcome.status);
        EXPECT_THAT(outcome.err, HasSubstr(place));
        EXPECT_THAT(outcome.err, HasSubstr("interrupted"));
        EXPECT_THAT(outcome.err, Not(HasSubstr("next.xml: error: no")));
        EXPECT_THAT(outcome.out, HasSubstr("c: stopped\nc: cleaned up\nc: deleted\n"));
    }
}

TEST_F(DeployerCheck, ASecondSignalEndsAScriptThatDoesNotEnd) {
    directory_.write("loop.ops",
                     "import(\"deploytest\")\nloadComponent(\"c\", \"deploytest::Consumer\")\nc.start()\n"
                     "while (true) { c.isRunning() }\n");
    ChildProcess deployer(lasting({"-s", "loop.ops"}));
    EXPECT_TRUE(deployer.waitForOutput("c: started", std::chrono::seconds(20)));
    deployer.send(SIGTERM);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    EXPECT_FALSE(deployer.waitForOutput("c: stopped", std::chrono::milliseconds(100)));
    deployer.send(SIGTERM);
    const Outcome outcome = deployer.finish();
    EXPECT_FALSE(outcome.timedOut);
    EXPECT_EQ(128 + SIGTERM, outcome.status);
    EXPECT_EQ("c: created\nc: started\n", outcome.out);
}

}  // namespace
