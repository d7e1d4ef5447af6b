// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The program as a user runs it.
#include "deployer_program.hpp"

#include <gmock/gmock.h>

#include <sys/stat.h>

namespace {

using namespace oroforge::test;
using std::chrono::seconds;
using testing::HasSubstr;
using testing::Not;

const char* const kApplication = R"(<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE properties SYSTEM "cpf.dtd">
<properties>
  <simple name="Import" type="string"><value>deploytest</value></simple>
  <struct name="wire" type="ConnPolicy">
    <simple name="type" type="short"><value>1</value></simple>
    <simple name="size" type="short"><value>100</value></simple>
  </struct>
  <struct name="producer" type="deploytest::Producer">
    <struct name="Activity" type="Activity">
      <simple name="Period" type="double"><value>0.01</value></simple>
      <simple name="Priority" type="short"><value>0</value></simple>
      <simple name="Scheduler" type="string"><value>ORO_SCHED_OTHER</value></simple>
    </struct>
    <struct name="Properties" type="PropertyBag">
      <simple name="first" type="long"><value>41</value></simple>
    </struct>
    <struct name="Ports" type="PropertyBag">
      <simple name="numbers" type="string"><value>wire</value></simple>
    </struct>
    <struct name="Peers" type="PropertyBag">
      <simple type="string"><value>consumer</value></simple>
    </struct>
    <simple name="AutoConf" type="boolean"><value>1</value></simple>
    <simple name="AutoStart" type="boolean"><value>1</value></simple>
  </struct>
  <struct name="consumer" type="deploytest::Consumer">
    <struct name="Ports" type="PropertyBag">
      <simple name="numbers" type="string"><value>wire</value></simple>
    </struct>
    <simple name="AutoStart" type="boolean"><value>1</value></simple>
  </struct>
</properties>
)";

class DeployerProgram : public deployer_test::DeployerInDirectory {
protected:
    /** Runs the application until its consumer is content. */
    Outcome runUntil(int signal) {
        directory_.write("app.xml", kApplication);
        return DeployerInDirectory::runUntil("consumer: ten numbers in a row", {"-s", "app.xml"}, signal);
    }
};

TEST_F(DeployerProgram, RunsAnApplicationUntilSigtermAndTakesItDownInReverseOrder) {
    const Outcome outcome = runUntil(SIGTERM);
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("consumer: first number 41"));
    EXPECT_THAT(outcome.out, Not(HasSubstr("lost")));
    EXPECT_THAT(outcome.out, HasSubstr("consumer: stopped\n"
                                       "producer: stopped\n"
                                       "consumer: cleaned up\n"
                                       "producer: cleaned up\n"
                                       "consumer: deleted\n"
                                       "producer: deleted\n"));
}

TEST_F(DeployerProgram, EndsInOrderOnSigint) {
    const Outcome outcome = runUntil(SIGINT);
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("producer: deleted"));
}

TEST_F(DeployerProgram, CheckConfiguresAndStartsNothing) {
    directory_.write("app.xml", kApplication);
    const Outcome outcome = run(command({"--check", "-s", "app.xml"}));
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("producer: configured"));
    EXPECT_THAT(outcome.out, Not(HasSubstr("started")));
    EXPECT_THAT(outcome.out, HasSubstr("producer: deleted"));
}

TEST_F(DeployerProgram, LaterFilesUseComponentsOfEarlierOnes) {
    directory_.write("app.xml", kApplication);
    directory_.write("more.xml",
                     "<properties><struct name='second' type='deploytest::Consumer'>"
                     "<struct name='Ports' type='PropertyBag'><simple name='numbers' "
                     "type='string'><value>wire</value></simple></struct>"
                     "<simple name='AutoStart' type='boolean'><value>1</value></simple></struct></properties>");
    ChildProcess deployer(lasting({"-s", "app.xml", "more.xml"}));
    EXPECT_TRUE(deployer.waitForOutput("second: ten numbers in a row", seconds(20)));
    deployer.send(SIGTERM);
    EXPECT_EQ(0, deployer.finish().status);
}

TEST_F(DeployerProgram, SiteFileReplacesTheImportOfTheComponentLibrary) {
    directory_.write("Robot-site.cpf",
                     "<properties><simple name='Import' type='string'><value>deploytest</value></simple></properties>");
    directory_.write("app.xml", "<properties><struct name='c' type='deploytest::Consumer'/></properties>");
    const Outcome outcome = run(command({"--check", "-s", "app.xml", "Robot"}));
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("c: created"));
}

TEST_F(DeployerProgram, HelpVersionAndBadOptions) {
    const Outcome help = run(command({"--help"}));
    EXPECT_EQ(0, help.status);
    EXPECT_THAT(help.out, HasSubstr("--site-file"));
    const Outcome version = run(command({"--version"}));
    EXPECT_EQ(0, version.status);
    EXPECT_THAT(version.out, HasSubstr("2.10"));
    const Outcome option = run(command({"--no-such-option"}));
    EXPECT_EQ(255, option.status);
    EXPECT_THAT(option.err, HasSubstr("no-such-option"));
    EXPECT_EQ("deployer-" OROCOS_TARGET_WORD
              ": error: unrecognised option '--strat'; did you mean '--start'?\n"
              "deployer-" OROCOS_TARGET_WORD " --help shows all options\n",
              run(command({"--strat", "app.xml"})).err);
    const Outcome level = run(command({"-l", "loud"}));
    EXPECT_EQ(255, level.status);
    EXPECT_THAT(level.err, HasSubstr("unknown log level 'loud', expected 'Never', 'Fatal'"));
    const Outcome kind = run(command({"-s", "file.txt"}));
    EXPECT_EQ(255, kind.status);
    EXPECT_THAT(kind.err, HasSubstr("unknown kind of file"));
}

TEST_F(DeployerProgram, AWordIsAFileOrTheNameOfTheDeployer) {
    directory_.write("app.xml",
                     "<properties><simple name='Import' type='string'><value>deploytest</value></simple></properties>");
    for (const char* word : {"app.xm", "./app", "."}) {
        const Outcome outcome = run(command({"--check", "app.xml", word}));
        EXPECT_EQ(255, outcome.status) << word;
        EXPECT_THAT(outcome.err, HasSubstr(std::string("'") + word + "' is neither a file to deploy")) << word;
    }
    const Outcome two = run(command({"--check", "app.xml", "One", "Two"}));
    EXPECT_EQ(0, two.status);
    EXPECT_THAT(two.err, HasSubstr("two names for the deployer, 'One' and 'Two'"));
    EXPECT_EQ("", run(command({"--check", "app.xml", "robot.left"})).err);
    EXPECT_EQ(0, run(command({"--check", "_x:=y", "/from:=/to", "app.xml", "my-robot", "__name:=z"})).status);
}

TEST_F(DeployerProgram, AStrayWordIsQuestioned) {
    directory_.write("app.xml",
                     "<properties><simple name='Import' type='string'><value>deploytest</value></simple></properties>");
    for (const std::string word : {"check", "dry-run", "start", "help"}) {
        const Outcome outcome = run(command({word, "app.xml"}));
        EXPECT_EQ(255, outcome.status) << word;
        EXPECT_THAT(outcome.err,
                    HasSubstr("'" + word + "' would be the name of the deployer; did you mean '--" + word));
    }
    const Outcome list = run(command({"list"}));
    EXPECT_EQ(0, list.status);
    EXPECT_THAT(list.err, HasSubstr("warning: 'list' is no command, but is now the name of the deployer; 'ls' at"));
    EXPECT_THAT(run(command({"--check", "run", "app.xml"})).err, HasSubstr("'-s FILE' deploys a file"));
    for (const char* name : {"check", "list"})
        EXPECT_EQ("", run(command({"--check", "app.xml", "--DeployerName", name})).err) << name;
    EXPECT_EQ("", run(command({"--check", "app.xml", "Robot"})).err);
}

TEST_F(DeployerProgram, APipeIsNoPropertyFile) {
    ASSERT_EQ(0, mkfifo((directory_ / "values.cpf").c_str(), 0600));
    directory_.write("app.xml",
                     "<properties><struct name='a' type='TaskContext'>"
                     "<simple name='UpdateProperties' type='string'><value>values.cpf</value></simple>"
                     "</struct></properties>");
    const Outcome outcome = run(command({"--check", "-s", "app.xml"}));
    EXPECT_EQ(255, outcome.status);
    EXPECT_THAT(outcome.err, HasSubstr("[DEP020] this is a pipe, expected a file: 'values.cpf'"));
}

TEST_F(DeployerProgram, WithoutAFileThereIsNothingToCheckOrToRun) {
    Command script = command({});
    script.program = RTTSCRIPT_PROGRAM;
    for (const Command& program : {command({"--check"}), command({"--dry-run", "Robot"}), script}) {
        const Outcome outcome = run(program);
        EXPECT_EQ(255, outcome.status);
        EXPECT_THAT(outcome.err, HasSubstr(": error: no file is given\n"));
    }
    EXPECT_EQ(0, run(command({})).status);
    directory_.write("Robot-site.cpf",
                     "<properties><simple name='Import' type='string'><value>deploytest</value></simple></properties>");
    EXPECT_EQ(0, run(command({"--dry-run", "Robot"})).status);
}

TEST_F(DeployerProgram, AScriptThatFailsIsToldAlsoWithoutTheLog) {
    directory_.write("bad.ops", "nothing()\n");
    const Outcome outcome = run(command({"--no-consolelog", "-s", "bad.ops"}));
    EXPECT_EQ(255, outcome.status);
    EXPECT_EQ("bad.ops: error: could not run the script, the log file says why\n", outcome.err);
}

TEST_F(DeployerProgram, LogLevelAndNoConsolelogDecideWhatIsShown) {
    directory_.write("app.xml", kApplication);
    const Outcome info = run(command({"-linfo", "--check", "-s", "app.xml"}));
    EXPECT_THAT(info.err, HasSubstr("created component 'producer'"));
    const Outcome silent = run(command({"--log-level", "INFO", "--no-consolelog", "--check", "-s", "app.xml"}));
    EXPECT_EQ("", silent.err);
    EXPECT_THAT(readFile(directory_ / "orocos.log"), HasSubstr("created component 'producer'"));
}

TEST_F(DeployerProgram, WrapperStartsTheProgramOfTheTarget) {
    std::filesystem::copy_file(DEPLOYER_WRAPPER, directory_ / "greet");
    const auto greeter = [this](const std::string& program, const std::string& text) {
        directory_.write(program, "#!/bin/sh\necho " + text + " $1\n");
        std::filesystem::permissions(directory_ / program, std::filesystem::perms::owner_all);
    };
    Command wrapper = command({"you"});
    wrapper.program = (directory_ / "greet").string();
    wrapper.environment = {{"OROCOS_TARGET", ""}};
    greeter("greet-one", "one");
    greeter("greet-two", "two");
    greeter("greet-corba-one", "another program");
    const Outcome unset = run(wrapper);
    EXPECT_EQ(1, unset.status);
    EXPECT_EQ("", unset.out);
    EXPECT_EQ(
        "greet: OROCOS_TARGET is not set; programs are installed for: one two\n"
        "greet: set it before, for example: export OROCOS_TARGET=one\n",
        unset.err);
    wrapper.environment = {{"OROCOS_TARGET", "two"}};
    EXPECT_EQ("two you\n", run(wrapper).out);
    wrapper.environment = {{"OROCOS_TARGET", "three"}};
    const Outcome unknown = run(wrapper);
    EXPECT_EQ(1, unknown.status);
    EXPECT_THAT(unknown.err, HasSubstr("no program for target 'three'"));
}

TEST_F(DeployerProgram, WrapperAddsTheComponentPathOfTheWorkspace) {
    Command wrapper = command({"--check", "-s", "app.xml"});
    wrapper.program = DEPLOYER_WRAPPER;
    directory_.write("app.xml", kApplication);
    std::filesystem::create_directory_symlink(DEPLOYER_TEST_PATH, directory_ / "components");
    directory_.write(".rtt_component_path", "components\n");
    wrapper.environment = {{"OROCOS_TARGET", OROCOS_TARGET_WORD}, {"RTT_COMPONENT_PATH", ""}};
    const Outcome accepted = run(wrapper);
    EXPECT_EQ(0, accepted.status) << accepted.err;
}

TEST_F(DeployerProgram, EndsWhereProcessorsAreTooFew) {
    const Outcome outcome = run(command({"--minNumberCPU", "1000"}));
    EXPECT_EQ(254, outcome.status);
    EXPECT_THAT(outcome.err, HasSubstr("1000 processors are needed"));
    EXPECT_EQ(0, run(command({"--minNumberCPU=1"})).status);
    EXPECT_EQ(255, run(command({"--minNumberCPU=-1"})).status);
}

TEST_F(DeployerProgram, SizeOfRealTimeMemoryIsTakenFromTheOption) {
    const Outcome outcome = run(command({"--rtalloc-mem-size", "1.5m"}));
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("bytes free of 1572864\n"));
    EXPECT_THAT(outcome.out, HasSubstr(" at most"));
    EXPECT_THAT(run(command({})).out, Not(HasSubstr("Real-time memory")));
}

TEST_F(DeployerProgram, UnusableSizeOfRealTimeMemoryIsAnError) {
    for (const std::string size : {"0", "k", "1kk", "much", "nan"}) {
        const Outcome outcome = run(command({"--rtalloc-mem-size", size}));
        EXPECT_EQ(255, outcome.status) << size;
        EXPECT_THAT(outcome.err, HasSubstr("no size of real-time memory: '" + size + "'"));
    }
    const Outcome tooFew = run(command({"--rtalloc-mem-size", "100"}));
    EXPECT_EQ(255, tooFew.status);
    EXPECT_THAT(tooFew.err, HasSubstr("100 bytes are too few for real-time memory"));
    Command unlimited = command({"--rtalloc-mem-size", "900000g"});
    // A sanitizer's malloc ends the program otherwise.
    for (const std::string tool : {"ASAN_OPTIONS", "TSAN_OPTIONS"})
        unlimited.environment[tool] = "allocator_may_return_null=1";
    const Outcome tooMany = run(unlimited);
    EXPECT_EQ(255, tooMany.status);
    EXPECT_THAT(tooMany.err, HasSubstr("the system does not give 966367641600000 bytes for real-time memory"));
}

}  // namespace
