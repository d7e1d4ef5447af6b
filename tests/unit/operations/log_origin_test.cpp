// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The origin of lines: the component whose code logs, or the thread.
#include "../flow/log_capture.hpp"
#include "probe.hpp"

#include <rtt/Activity.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/Logger.hpp>
#include <rtt/OutputPort.hpp>

#include <atomic>
#include <memory>
#include <string>
#include <thread>

#include <pthread.h>
#include <sys/syscall.h>
#include <unistd.h>

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::makeManual;
using oroforge::test::Probe;
using oroforge::test::Steps;

namespace {

void say(const std::string& text) { log(Error) << text << endlog(); }

struct LogOrigin : testing::Test {
    flow_test::LogCapture log;
    Probe c{"gripper", TaskContext::PreOperational};

    void expect(const std::string& line) {
        say("end");  // behind the lines of real-time threads
        EXPECT_TRUE(log.contains(line + "\n")) << line << " is not in: " << log.text();
    }
};

TEST_F(LogOrigin, IsTheComponentOfEveryHook) {
    makeManual(c);
    c.onConfigure = [] { return say("configure"), true; };
    c.onStart = [] { return say("start"), true; };
    c.onUpdate = [] { say("update"); };
    c.onError = [] { say("error"); };
    c.onStop = [] { say("stop"); };
    c.onCleanup = [] { say("cleanup"); };
    c.onException = [] { say("exception"); };
    ASSERT_TRUE(c.configure() && c.start());
    c.update();
    c.error();
    c.update();
    c.stop();
    c.cleanup();
    c.exception();
    for (const char* hook : {"configure", "start", "update", "error", "stop", "cleanup", "exception"})
        expect(std::string("[ ERROR  ][gripper] ") + hook);
    say("outside");
    expect("[main] outside");
}

TEST_F(LogOrigin, IsTheComponentInItsOwnThread) {
    ASSERT_TRUE(c.setActivity(new Activity(0, 0, "hand")));
    c.onUpdate = [] { say("update"); };
    ASSERT_TRUE(c.configure() && c.start());
    ASSERT_TRUE(eventually([this] { return c.updates != 0; }));
    c.stop();
    expect("[gripper] update");
}

TEST_F(LogOrigin, IsTheComponentOfOperationsCallbacksAndFunctions) {
    makeManual(c);
    OutputPort<int> out("out");
    InputPort<int> in("in");
    c.addOperation(
        "op", [] { say("operation"); }, OwnThread);
    c.addEventPort(in, [](base::PortInterface*) { say("callback"); });
    Probe caller("caller");
    OperationCaller<void()> op(c.getOperation("op"), caller.engine());
    ASSERT_TRUE(out.connectTo(&in) && c.configure() && c.start());
    auto handle = op.send();
    out.write(1);
    Steps function([] { return say("function"), false; });
    ASSERT_TRUE(c.engine()->runFunction(&function));
    c.update();
    for (const char* what : {"operation", "callback", "function"}) expect(std::string("[gripper] ") + what);
}

TEST_F(LogOrigin, IsTheInnerOfModuleAndComponent) {
    makeManual(c);
    Logger::In outer("outer");
    c.onConfigure = [] {
        say("one");
        Logger::In inner("inner");
        return say("two"), true;
    };
    say("zero");
    ASSERT_TRUE(c.configure());
    say("three");
    for (const char* line : {"[outer] zero", "[gripper] one", "[inner] two", "[outer] three"}) expect(line);
    Probe other("other", TaskContext::PreOperational);
    other.onConfigure = [] { return say("nested"), true; };
    c.onCleanup = [&] {
        Logger::In in("of gripper");
        other.configure();
        say("after");
    };
    ASSERT_TRUE(c.cleanup());
    expect("[other] nested");
    expect("[of gripper] after");
}

TEST_F(LogOrigin, ModulesThatAreNotScopedEndAsWell) {
    Logger& logger = *Logger::Instance();
    c.onConfigure = [&] {
        const std::string before = logger.getLogModule();
        EXPECT_EQ(before, "gripper");
        logger.in("module");
        EXPECT_EQ(logger.getLogModule(), "module");
        say("one");
        logger.out(before);
        EXPECT_EQ(logger.getLogModule(), "gripper");
        return true;
    };
    ASSERT_TRUE(c.configure());
    EXPECT_EQ(logger.getLogModule(), "main") << "the component's name did not stay";
    expect("[module] one");
}

TEST_F(LogOrigin, IsTheComponentThatTheRuntimeReports) {
    c.onConfigure = []() -> bool { throw std::runtime_error("planted"); };
    EXPECT_FALSE(c.configure());
    EXPECT_TRUE(log.contains("[gripper] gripper: the hook of configure() threw: planted")) << log.text();
}

TEST_F(LogOrigin, OfADestroyedComponentIsNotRead) {
    auto mortal = std::make_unique<Probe>("a name that is too long to be kept in the object itself");
    std::atomic<bool> done{false};
    mortal->addOperation(
        "end", [&] { mortal.reset(), say("afterwards"), done = true; }, OwnThread);
    OperationCaller<void()> end(mortal->getOperation("end"), c.engine());
    auto handle = end.send();
    ASSERT_TRUE(eventually([&] { return done.load(); }));
    expect("[(destroyed)] afterwards");
}

TEST_F(LogOrigin, IsTheThreadOtherwise) {
    long id = 0;
    std::thread([&] {
        id = syscall(SYS_gettid);
        say("anonymous");
        pthread_setname_np(pthread_self(), "worker");
        say("named");
    }).join();
    expect("[thread " + std::to_string(id) + "] anonymous");
    expect("[worker] named");
}

}  // namespace
