// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The programs and their options (section 1.2), and what programs without CORBA say of it (2.5, 2.6).
#include "snippets.hpp"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <thread>

namespace {

using namespace manual_test;
using namespace oroforge::test;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::vector<std::string> kLevels = {"Never",   "Fatal", "Critical", "Error",
                                          "Warning", "Info",  "Debug",    "Realtime"};

class Programs : public Snippets {
protected:
    static std::string worker(const std::string& name) {
        return bag(name, "line::Worker", simple("AutoConf", "boolean", "1"));
    }
};

TEST_F(Programs, TheNameOfTheDeployerIsGivenInSeveralForms) {
    const std::vector<std::vector<std::string>> forms = {
        {"Other"}, {"--DeployerName", "Other"}, {"--DeployerName=Other"}, {"-l", "warning", "Other"}};
    expectAtPrompt({}, {{"Deployer.isConfigured()", kTrue}});
    for (const std::vector<std::string>& form : forms) expectAtPrompt(form, {{"Other.isConfigured()", kTrue}});
}

/** The scripts beside the programs, which are named as these without the target. */
TEST_F(Programs, AreStartedByScriptsOnceTheTargetIsSet) {
    directory_.write("app.ops", "this.isConfigured()\n");
    for (const std::string program : {DEPLOYER_PROGRAM, RTTSCRIPT_PROGRAM}) {
        const std::string script = program.substr(0, program.rfind('-')), target = program.substr(script.size() + 1);
        environment_["OROCOS_TARGET"] = "";
        const Outcome refused = run(command(script, {"-s", "app.ops"}));
        EXPECT_EQ(1, refused.status);
        EXPECT_THAT(refused.err, AllOf(HasSubstr("OROCOS_TARGET is not set"), HasSubstr(" " + target + "\n")));
        environment_["OROCOS_TARGET"] = target;
        EXPECT_EQ(run(command(program, {"--version"})).out, run(command(script, {"--version"})).out);
        const Outcome started = run(command(script, {"-s", "app.ops"}));
        EXPECT_EQ(0, started.status) << started.err;
    }
}

TEST_F(Programs, HelpNamesAllOptions) {
    const Outcome outcome = run(command(DEPLOYER_PROGRAM, {"--help"}));
    EXPECT_EQ(0, outcome.status);
    for (const char* option :
         {"--help", "-s [ --start ]", "-l [ --log-level ]", "--no-consolelog", "-d [ --daemon ]", "--DeployerName"})
        EXPECT_THAT(outcome.out, HasSubstr(option));
}

TEST_F(Programs, FilesAreTakenInTheOrderOfTheCommandLine) {
    writeXml("one.xml", import("line") + worker("one"));
    directory_.write("two.ops", "loadComponent(\"two\", \"line::Worker\")\ntwo.configure()\n");
    writeXml("three.cpf", worker("three"));
    directory_.write("four.osd", "loadComponent(\"four\", \"line::Worker\")\nfour.configure()\n");
    const Outcome outcome = rttscript({"--start", "one.xml", "-s", "two.ops", "--start=three.cpf", "-sfour.osd"});
    EXPECT_EQ(0, outcome.status) << outcome.err;
    const std::string text = ": configured with speed 1, label ''\n";
    EXPECT_THAT(outcome.out, HasSubstr("one" + text + "two" + text + "three" + text + "four" + text));
}

TEST_F(Programs, LogLevelsHaveAnyCaseAndOverrideTheEnvironment) {
    writeXml("app.xml", import("line") + worker("w"));
    const auto logged = [this](std::vector<std::string> options) {
        options.insert(options.end(), {"-s", "app.xml"});
        return testing::Value(rttscript(options).err, HasSubstr("created component 'w'"));
    };
    environment_["ORO_LOGLEVEL"] = "5";
    EXPECT_TRUE(logged({}));
    for (std::size_t i = 0; i < kLevels.size(); ++i) {
        std::string level = kLevels[i];
        for (std::size_t j = i % 2; j < level.size(); j += 2) level[j] ^= 0x20;
        EXPECT_EQ(kLevels[i] == "Info" || kLevels[i] == "Debug", logged({"--log-level", level})) << level;
    }
    environment_["ORO_LOGLEVEL"] = "3";
    EXPECT_FALSE(logged({}));
    EXPECT_TRUE(logged({"-linfo"}));
}

TEST_F(Programs, TheExamplesOfTheCommandLine) {
    writeXml("myfile.xml", import("line") + worker("w"));
    writeXml("leftfile.xml", import("line") + worker("w"));
    const std::string configured = "w: configured with speed 1, label ''\n";
    expectAtPrompt({"--log-level", "warning", "-s", "myfile.xml"}, {{"w.isConfigured()", configured + kTrue}});
    std::vector<std::string> words = {"-l", "fatal", "--no-consolelog", "-s", "leftfile.xml", "LeftDeployer"};
    const std::vector<Typed> session = {{"LeftDeployer.isConfigured()", configured + kTrue},
                                        {"w.isConfigured()", kTrue}};
    expectAtPrompt(words, session);
    for (const char* word :
         {"--", "-ORBInitRef", "NameService=corbaloc:iiop:me.mine.home:2809/NameService", "-ORBFooBar", "1"})
        words.push_back(word);
    expectAtPrompt(words, session);
}

TEST_F(Programs, WithoutConsoleLogTheFileStillHasIt) {
    writeXml("app.xml", import("line") + worker("w"));
    const Outcome outcome = rttscript({"-l", "info", "--no-consolelog", "-s", "app.xml"});
    EXPECT_EQ("", outcome.err);
    EXPECT_THAT(readFile(directory_ / "orocos.log"), HasSubstr("created component 'w'"));
}

TEST_F(Programs, ADaemonRunsInTheBackgroundWithoutPrompt) {
    writeXml("app.xml", import("line") + worker("w"));
    // What it writes goes to files: a pipe would be held open.
    directory_.write("pid.ops",
                     "loadService(\"Deployer\", \"os\")\n"
                     "os.execute(\"echo $PPID > pid; mv pid pid.whole\")\n");
    directory_.write("start.sh", "\"$1\" --daemon -s app.xml -s pid.ops > out 2> err\n");
    Command shell = command("/bin/sh", {"start.sh", DEPLOYER_PROGRAM});
    shell.input = "1 + 1\n";
    EXPECT_EQ(0, run(shell).status);
    const auto soon = [](auto condition) {
        for (int i = 0; i < 1000 && !condition(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(20));
        return condition();
    };
    ASSERT_TRUE(soon([this] { return std::filesystem::exists(directory_ / "pid.whole"); }))
        << readFile(directory_ / "err");
    const pid_t daemon = std::atoi(readFile(directory_ / "pid.whole").c_str());
    ASSERT_GT(daemon, 1);
    EXPECT_EQ(0, ::kill(daemon, 0)) << "it goes on";
    EXPECT_EQ(0, ::kill(daemon, SIGTERM));
    EXPECT_TRUE(soon([this] { return testing::Value(readFile(directory_ / "out"), HasSubstr("w: cleaned up")); }));
    EXPECT_EQ("w: configured with speed 1, label ''\nw: cleaned up\n", readFile(directory_ / "out"));
}

TEST_F(Programs, TheirElementsOfCorbaAreTakenWithANotice) {
    writeXml("app.xml", bag("Reporter", "OCL::FileReporting",
                            "<!-- CORBA specific extensions -->\n" + simple("Server", "boolean", "1") +
                                simple("UseNamingService", "boolean", "1")));
    const Outcome outcome = rttscript({"-s", "app.xml"});
    EXPECT_EQ(0, outcome.status);
    EXPECT_THAT(outcome.err,
                HasSubstr("app.xml:6:1: warning: [DEP019] 'Server' is ignored: this deployer has no CORBA"));
    writeXml("app.xml", bag("Reporter", "OCL::FileReporting",
                            simple("Server", "boolean", "0") + simple("UseNamingService", "boolean", "0")));
    EXPECT_EQ("", rttscript({"-s", "app.xml"}).err);
}

TEST_F(Programs, ServersAreNoOperationOfThisDeployer) {
    const Outcome outcome = atPrompt(
        {}, {{"loadComponent(\"Reporter\", \"OCL::FileReporting\")", kTrue}, {"server(\"Reporter\", true)", kNothing}});
    EXPECT_THAT(outcome.err, HasSubstr("component 'Deployer' has no operation 'server'"));
}

TEST_F(Programs, ComponentsOfOtherProcessesAreRefusedInPlainWords) {
    const std::string reason = " means a component of another process, and this deployer has no CORBA";
    const Outcome typed = atPrompt({}, {{"loadComponent(\"MyComponent\", \"CORBA\")", kFalse},
                                        {"loadComponent(\"MyComponent.ior\", \"IORFile\")", kFalse},
                                        {"loadComponent(\"IOR:01\", \"IOR\")", kFalse}});
    EXPECT_THAT(typed.err, AllOf(HasSubstr("component 'MyComponent': type 'CORBA'" + reason),
                                 HasSubstr("component 'MyComponent.ior': type 'IORFile'" + reason),
                                 HasSubstr("component 'IOR:01': type 'IOR'" + reason)));
    writeXml("app.xml",
             "<struct name=\"MyComponent\" type=\"CORBA\">\n</struct>\n"
             "<struct name=\"MyComponent.ior\" type=\"IORFile\">\n</struct>\n"
             "<struct name=\"IOR:01\" type=\"IOR\">\n</struct>\n");
    const Outcome filed = rttscript({"-s", "app.xml"});
    EXPECT_EQ(255, filed.status);
    EXPECT_THAT(filed.err, AllOf(HasSubstr("app.xml:4:34: error: [DEP031] type 'CORBA'" + reason),
                                 HasSubstr("app.xml:6:38: error: [DEP031] type 'IORFile'" + reason),
                                 HasSubstr("app.xml:8:29: error: [DEP031] type 'IOR'" + reason)));
    EXPECT_THAT(filed.err, Not(HasSubstr("unknown component type")));
}

}  // namespace
