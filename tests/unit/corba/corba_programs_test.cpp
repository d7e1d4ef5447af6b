// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The programs with CORBA, with a real naming service; what the deployment manual shows in sections 2.5 and 2.6.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/child_process.hpp>
#include <support/temp_dir.hpp>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace {

using namespace oroforge::test;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr std::chrono::seconds kPatience{30};

/** A TCP port that nobody uses at this moment. */
int freePort() {
    const int plug = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    EXPECT_EQ(bind(plug, reinterpret_cast<sockaddr*>(&address), size), 0);
    EXPECT_EQ(getsockname(plug, reinterpret_cast<sockaddr*>(&address), &size), 0);
    close(plug);
    return ntohs(address.sin_port);
}

const char kServed[] = R"(<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE properties SYSTEM "cpf.dtd">
<properties>
  <simple name="Import" type="string"><value>ocl</value></simple>
  <struct name="hello" type="OCL::HelloWorld">
    <simple name="Server" type="boolean"><value>1</value></simple>
    <simple name="UseNamingService" type="boolean"><value>NAMING</value></simple>
    <struct name="Activity" type="PeriodicActivity">
      <simple name="Period" type="double"><value>0.02</value></simple>
      <simple name="Priority" type="short"><value>0</value></simple>
      <simple name="Scheduler" type="string"><value>ORO_SCHED_OTHER</value></simple>
    </struct>
    <simple name="AutoConf" type="boolean"><value>1</value></simple>
    <simple name="AutoStart" type="boolean"><value>1</value></simple>
  </struct>
</properties>
)";

const char kConnected[] = R"(<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE properties SYSTEM "cpf.dtd">
<properties>
  <simple name="Import" type="string"><value>ocl</value></simple>
  <struct name="Texts" type="ConnPolicy"><simple name="type" type="short"><value>0</value></simple></struct>
  <struct name="NAME" type="TYPE">
    <struct name="Properties" type="PropertyBag">
      <simple name="the_property" type="string"><value>set by XML</value></simple>
    </struct>
    <struct name="Ports" type="PropertyBag"><simple name="the_results" type="string"><value>Texts</value></simple></struct>
  </struct>
  <struct name="listener" type="OCL::HelloWorld">
    <struct name="Ports" type="PropertyBag">
      <simple name="the_buffer_port" type="string"><value>Texts</value></simple>
    </struct>
    <simple name="AutoConf" type="boolean"><value>1</value></simple>
  </struct>
</properties>
)";

const char kUse[] = R"(require("os")
require("print")
var string text = "nothing"
var int tries = 0
while (text == "nothing" && tries != 500) {
  listener.the_buffer_port.read(text)
  os.millisleep(10)
  set tries = tries + 1
}
print.ln("read " + text)
print.ln("property " + hello.the_property)
print.ln("answer " + hello.the_method())
if (hello.isRunning()) then print.ln("it runs")
)";

class CorbaPrograms : public testing::Test {
protected:
    void startNames() {
        std::filesystem::create_directory(directory_ / "names");
        const std::string port = std::to_string(port_);
        Command command;
        command.program = OMNINAMES;
        const bool isFirst = std::filesystem::is_empty(directory_ / "names");
        command.arguments = {"-ignoreport", "-logdir", (directory_ / "names").string(), "-ORBendPoint",
                             "giop:tcp:127.0.0.1:" + port};
        if (isFirst) command.arguments.insert(command.arguments.begin(), {"-start", port});
        names_ = std::make_unique<ChildProcess>(command);
        // It is there when somebody can connect.
        for (int i = 0; i != 3000 && !answers(); ++i) usleep(10000);
        ASSERT_TRUE(answers());
    }
    bool answers() const {
        const int plug = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(static_cast<std::uint16_t>(port_));
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        const bool good = connect(plug, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
        close(plug);
        return good;
    }
    std::vector<std::string> orb() const {
        return {"-ORBInitRef", "NameService=corbaloc::127.0.0.1:" + std::to_string(port_) + "/NameService"};
    }
    Command command(const std::string& program, const std::vector<std::string>& words) const {
        Command made;
        made.program = program;
        made.arguments = words;
        made.directory = directory_.path();
        made.environment = {
            {"ORO_LOGFILE", "/dev/null"}, {"OROCOS_TARGET", TARGET_NAME}, {"OMNIORB_CONFIG", "/dev/null"}};
        made.timeout = kPatience;
        return made;
    }
    std::vector<std::string> withOrb(std::vector<std::string> words) const {
        words.emplace_back("--");
        for (const std::string& word : orb()) words.push_back(word);
        return words;
    }
    /** A server whose component "hello" can be reached when this returns. */
    void serve(bool naming, std::vector<std::string> words = {}) {
        std::string file = kServed;
        file.replace(file.find("NAMING"), 6, naming ? "1" : "0");
        directory_.write("served.xml", file);
        words.insert(words.end(), {"-l", "info", "-s", "served.xml"});
        if (naming) words = withOrb(words);
        std::string line = std::string("exec ") + CDEPLOYER;
        for (const std::string& word : words) line += " " + word;
        server_ = std::make_unique<ChildProcess>(command("/bin/sh", {"-c", line + " 2>&1"}));
        ASSERT_TRUE(server_->waitForOutput("started component 'hello'", kPatience));
    }
    void connectFrom(const std::string& name, const std::string& type) {
        std::string file = kConnected;
        file.replace(file.find("NAME\""), 4, name);
        file.replace(file.find("\"TYPE") + 1, 4, type);
        directory_.write("connected.xml", file);
        directory_.write("use.ops", kUse);
    }
    Outcome browse(const std::string& name, const std::string& input) const {
        std::vector<std::string> words{name};
        for (const std::string& word : orb()) words.push_back(word);
        Command made = command(CTASKBROWSER, words);
        made.input = input;
        return run(made);
    }
    void expectTheirUse(const Outcome& outcome) {
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_THAT(outcome.out, AllOf(HasSubstr("read Hello World!"), HasSubstr("property set by XML"),
                                       HasSubstr("answer Hello World"), HasSubstr("it runs")))
            << outcome.err;
    }
    std::string reference(const std::string& file) const {
        std::string text;
        std::ifstream(directory_ / file) >> text;
        return text;
    }

    TempDir directory_;
    const int port_ = freePort();
    std::unique_ptr<ChildProcess> names_, server_;
};

TEST_F(CorbaPrograms, AComponentIsFoundByItsName) {
    startNames();
    serve(true);
    connectFrom("hello", "CORBA");
    expectTheirUse(run(command(RTTSCRIPT_CORBA, withOrb({"-s", "connected.xml", "-s", "use.ops"}))));
    connectFrom("hello", "TaskContextProxy");
    expectTheirUse(run(command(RTTSCRIPT_CORBA, withOrb({"Second", "-s", "connected.xml", "-s", "use.ops"}))));
    EXPECT_THAT(browse("hello", "ls\n").out, HasSubstr("Component hello [R]")) << "it goes on when its user has ended";
}

TEST_F(CorbaPrograms, AComponentIsFoundByItsReference) {
    serve(false);
    ASSERT_EQ(reference("hello.ior").substr(0, 4), "IOR:");
    connectFrom("hello.ior", "IORFile");
    expectTheirUse(run(command(RTTSCRIPT_CORBA, {"-s", "connected.xml", "-s", "use.ops"})));
    connectFrom(reference("hello.ior"), "IOR");
    expectTheirUse(run(command(RTTSCRIPT_CORBA, {"-s", "connected.xml", "-s", "use.ops"})));
}

TEST_F(CorbaPrograms, ScriptsMakeServersAndProxies) {
    startNames();
    directory_.write("serve.ops",
                     "import(\"ocl\")\nloadComponent(\"one\", \"OCL::HelloWorld\")\n"
                     "server(\"one\", true)\naliasServer(\"one\", \"other\", true)\n");
    server_ = std::make_unique<ChildProcess>(command(
        "/bin/sh",
        {"-c", std::string("exec ") + CDEPLOYER + " -l info -s serve.ops -- " + orb()[0] + " " + orb()[1] + " 2>&1"}));
    ASSERT_TRUE(server_->waitForOutput("component 'other' is in the naming service", kPatience));
    directory_.write("use.ops",
                     "require(\"print\")\nloadComponent(\"other\", \"CORBA\")\n"
                     "print.ln(other.the_method())\nprint.ln(one.the_constant)\n"
                     "if (!loadComponent(\"nobody\", \"CORBA\")) then print.ln(\"nobody is there\")\n");
    const Outcome outcome = run(command(RTTSCRIPT_CORBA, withOrb({"-s", "use.ops"})));
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("Hello World"), HasSubstr("Hello Constant"), HasSubstr("nobody is there")))
        << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("the naming service has no component of that name"));
}

TEST_F(CorbaPrograms, ASecondProcessTakesTheNameOfOneThatWasKilled) {
    startNames();
    serve(true);
    server_->send(SIGKILL);
    (void)server_->finish();
    const Outcome lost = browse("hello", "ls\n");
    EXPECT_EQ(lost.status, 255);
    EXPECT_THAT(lost.err, HasSubstr("its process cannot be reached"));
    serve(true);
    server_->send(SIGTERM);
    const Outcome ended = server_->finish();
    EXPECT_EQ(ended.status, 0);
    EXPECT_THAT(ended.out, HasSubstr("the naming service had another component 'hello', which this one replaces"));
    EXPECT_THAT(browse("hello", "").err, HasSubstr("the naming service has no component of that name"))
        << "its end takes the name away";
}

TEST_F(CorbaPrograms, TheNamingServiceMayBeStartedAgain) {
    startNames();
    serve(true);
    names_->send(SIGKILL);
    (void)names_->finish();
    const Outcome without = browse("hello", "");
    EXPECT_EQ(without.status, 255);
    EXPECT_THAT(without.err, HasSubstr("no naming service: it cannot be reached"));
    startNames();
    EXPECT_THAT(browse("hello", "ls\n").out, HasSubstr("Component hello [R]"));
}

TEST_F(CorbaPrograms, ACheckLeavesOtherProcessesAlone) {
    startNames();
    serve(true);
    connectFrom("hello", "CORBA");
    const Outcome checked = run(command(RTTSCRIPT_CORBA, withOrb({"--check", "-s", "connected.xml"})));
    EXPECT_EQ(checked.status, 0) << checked.err;
    const Outcome after = browse("hello", "ls\nthe_property\n");
    EXPECT_THAT(after.out, AllOf(HasSubstr("Component hello [R]"), HasSubstr("Hello Property")));
}

TEST_F(CorbaPrograms, ANamingServiceCanBeRequired) {
    const Outcome required = run(command(CDEPLOYER, withOrb({"--require-name-service"})));
    EXPECT_EQ(required.status, 255);
    EXPECT_THAT(required.err, AllOf(HasSubstr("component 'Deployer' does not get into the naming service, which is "
                                              "required: it cannot be reached"),
                                    Not(HasSubstr("IOR:"))));
    directory_.write("empty.ops", "var int a = 1\n");
    const Outcome without = run(command(RTTSCRIPT_CORBA, {"-s", "empty.ops"}));
    EXPECT_EQ(without.status, 0);
    EXPECT_THAT(without.err, AllOf(HasSubstr("its place is not given"), HasSubstr("IOR:")));
    EXPECT_EQ(reference("Deployer.ior").substr(0, 4), "IOR:");
}

TEST_F(CorbaPrograms, AConsoleForAnotherProcess) {
    startNames();
    serve(true, {"Robot"});
    const Outcome session = browse("Robot", "hello.the_property = \"typed\"\nhello.the_property\ncd hello\nls\nquit\n");
    EXPECT_EQ(session.status, 0) << session.err;
    EXPECT_THAT(session.out, AllOf(HasSubstr("= \"typed\""), HasSubstr("the_results"), HasSubstr("the_buffer_port")));
    EXPECT_EQ(run(command(CTASKBROWSER, {})).status, 255);
    EXPECT_THAT(run(command(CTASKBROWSER, {"--help"})).err, HasSubstr("Usage: ctaskbrowser"));
    EXPECT_EQ(run(command(CTASKBROWSER, {"--version"})).status, 0);
    const Outcome broken = browse("IOR:0123", "");
    EXPECT_EQ(broken.status, 255);
    EXPECT_THAT(broken.err, HasSubstr("it is no complete reference"));
    EXPECT_EQ(browse("Robot", "shutdown()\nquit\n").status, 0);
    EXPECT_EQ(server_->finish().status, 0) << "the operation ends the deployer";
}

TEST_F(CorbaPrograms, AConsoleBesideTheServer) {
    startNames();
    serve(true);
    connectFrom("hello", "CORBA");
    Command console = command(DEPLOYER_CORBA, withOrb({"-s", "connected.xml"}));
    console.input = "cd listener\nls\nquit\n";
    const Outcome session = run(console);
    EXPECT_EQ(session.status, 0) << session.err;
    EXPECT_THAT(session.out, HasSubstr("<- hello.the_results of another process  "));
}

TEST_F(CorbaPrograms, WrongArgumentsOfTheOrbAreNamed) {
    for (const char* program : {CDEPLOYER, DEPLOYER_CORBA, RTTSCRIPT_CORBA}) {
        directory_.write("empty.ops", "");
        const Outcome wrong = run(command(program, {"-s", "empty.ops", "--", "-ORBFooBar", "1"}));
        EXPECT_EQ(wrong.status, 255) << program;
        EXPECT_THAT(wrong.err, AllOf(HasSubstr("-ORBFooBar"), HasSubstr("the ORB cannot be started")));
    }
}

TEST_F(CorbaPrograms, WithoutCorbaTheDeployerSaysWhichProgramHasIt) {
    connectFrom("hello", "CORBA");
    const Outcome outcome = run(command(RTTSCRIPT, {"-s", "connected.xml"}));
    EXPECT_EQ(outcome.status, 255);
    EXPECT_THAT(outcome.err, HasSubstr("this deployer has no CORBA; cdeployer and deployer-corba have it"));
}

}  // namespace
