// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a component says when something goes wrong: who it is, where, and why.
#include "../flow/log_capture.hpp"
#include "probe.hpp"

#include <rtt/Activity.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/Logger.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/extras/SlaveActivity.hpp>

#include <ostream>
#include <stdexcept>

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::makeManual;
using oroforge::test::Probe;
using oroforge::test::Steps;

namespace {

[[noreturn]] void fail() { throw std::runtime_error("planted"); }

struct ComponentLog : testing::Test {
    flow_test::LogCapture log;
    Probe c{"gripper", TaskContext::PreOperational};

    void expect(std::initializer_list<const char*> parts) {
        EXPECT_TRUE(log.contains("ERROR") || log.contains("Error")) << log.text();
        for (const char* part : parts) EXPECT_TRUE(log.contains(part)) << part << " is not in: " << log.text();
    }
};

TEST_F(ComponentLog, SaysNothingOfAnOrdinaryLife) {
    EXPECT_TRUE(c.configure() && c.start() && c.stop() && c.cleanup());
    c.onConfigure = [] { return false; };
    EXPECT_FALSE(c.configure()) << "to refuse is the right of a hook";
    EXPECT_EQ(log.text(), "");
}

// As the manual shows it.
TEST_F(ComponentLog, NamesTheComponentInWhatItsCodeLogs) {
    {
        Logger::In in(c.getName());
        RTT::log(Error) << " failed, ...." << RTT::endlog();
    }
    expect({"[gripper]", " failed, ...."});
}

// The caller only gets "false".
TEST_F(ComponentLog, TellsWhyAComponentDoesNotStart) {
    EXPECT_FALSE(c.start());
    EXPECT_TRUE(log.contains("Warning") &&
                log.contains("gripper: start() returns false: the component is not configured"))
        << log.text();
    c.onUpdate = [] { fail(); };
    ASSERT_TRUE(c.configure() && c.start());
    ASSERT_TRUE(eventually([this] { return c.inException(); }));
    EXPECT_FALSE(c.start());
    EXPECT_TRUE(log.contains("in state Exception; recover() comes first")) << log.text();
}

TEST_F(ComponentLog, SaysNothingOfAComponentThatRunsAlready) {
    ASSERT_TRUE(c.configure() && c.start());
    EXPECT_FALSE(c.start());
    EXPECT_EQ(log.text(), "");
}

TEST_F(ComponentLog, TellsOfHooksThatRefuseWhenAsked) {
    Logger::Instance()->setLogLevel(Logger::Info);
    c.onConfigure = [] { return false; };
    EXPECT_FALSE(c.configure());
    EXPECT_TRUE(log.contains("gripper: configure() returns false: configureHook() did")) << log.text();
    c.onConfigure = nullptr;
    c.onStart = [] { return false; };
    ASSERT_TRUE(c.configure());
    EXPECT_FALSE(c.start());
    EXPECT_TRUE(log.contains("gripper: start() returns false: startHook() did")) << log.text();
    Logger::Instance()->setLogLevel(Logger::Warning);
}

TEST_F(ComponentLog, NamesTheHookThatThrew) {
    c.onConfigure = [] { return fail(), true; };
    EXPECT_FALSE(c.configure());
    expect({"gripper", "configure()", "planted"});
}

TEST_F(ComponentLog, NamesStartHook) {
    c.onStart = [] { return fail(), true; };
    ASSERT_TRUE(c.configure());
    EXPECT_FALSE(c.start());
    expect({"gripper", "start()", "planted"});
}

TEST_F(ComponentLog, NamesStopHook) {
    c.onStop = [] { fail(); };
    ASSERT_TRUE(c.configure() && c.start());
    EXPECT_FALSE(c.stop());
    expect({"gripper", "stop()", "planted"});
}

TEST_F(ComponentLog, NamesCleanupHook) {
    c.onCleanup = [] { throw 42; };
    ASSERT_TRUE(c.configure());
    EXPECT_FALSE(c.cleanup());
    expect({"gripper", "cleanup()"});
}

TEST_F(ComponentLog, NamesUpdateHook) {
    makeManual(c);
    c.onUpdate = [] { fail(); };
    ASSERT_TRUE(c.configure() && c.start());
    c.update();
    EXPECT_TRUE(c.inException());
    expect({"gripper", "updateHook()", "planted"});
}

TEST_F(ComponentLog, NamesErrorHook) {
    makeManual(c);
    c.onError = [] { fail(); };
    ASSERT_TRUE(c.configure() && c.start());
    c.error();
    c.update();
    EXPECT_TRUE(c.inException());
    expect({"gripper", "errorHook()", "planted"});
}

TEST_F(ComponentLog, NamesACallbackAndAFunction) {
    makeManual(c);
    OutputPort<int> out("out");
    InputPort<int> in("in");
    c.addEventPort(in, [](base::PortInterface*) { fail(); });
    ASSERT_TRUE(out.connectTo(&in));
    ASSERT_TRUE(c.configure() && c.start());
    out.write(1);
    c.update();
    EXPECT_TRUE(c.inException());
    expect({"gripper", "callback", "planted"});
    Steps function([]() -> bool { throw std::runtime_error("function planted"); });
    ASSERT_TRUE(c.engine()->runFunction(&function));
    c.update();
    EXPECT_FALSE(function.isLoaded());
    expect({"function planted"});
}

TEST_F(ComponentLog, NamesTheComponentOfAnOperationThatThrew) {
    makeManual(c);
    c.addOperation(
        "op", [] { fail(); }, OwnThread);
    Probe caller("caller");
    OperationCaller<void()> op(c.getOperation("op"), caller.engine());
    auto handle = op.send();
    c.update();
    EXPECT_TRUE(c.inException());
    EXPECT_THROW(handle.collect(), std::runtime_error);
    expect({"gripper", "operation", "planted"});
}

TEST_F(ComponentLog, TellsOfAHookThatContradictsItself) {
    c.onConfigure = [this] { return c.exception(), true; };
    EXPECT_FALSE(c.configure());
    expect({"gripper", "configure()"});
}

TEST_F(ComponentLog, TellsWhatLedToFatalError) {
    c.onException = [] { fail(); };
    c.exception();
    EXPECT_TRUE(c.inFatalError());
    expect({"gripper", "Exception", "planted"});
}

TEST_F(ComponentLog, TellsThatItDoesNotStop) {
    c.getActivity<Activity>()->setStopTimeout(0.02);
    std::atomic<bool> inside{false}, release{false};
    c.onUpdate = [&] {
        inside = true;
        while (!release) usleep(200);
    };
    ASSERT_TRUE(c.configure() && c.start());
    ASSERT_TRUE(eventually([&] { return inside.load(); }));
    EXPECT_FALSE(c.stop());
    release = true;
    expect({"gripper", "stop()"});
    EXPECT_TRUE(eventually([&] { return c.stop(); }));
}

TEST_F(ComponentLog, TellsThatItIsDestroyedWhileItRuns) {
    for (const bool stops : {true, false}) {
        TaskContext careless("careless");
        ASSERT_TRUE(careless.start());
        if (stops) careless.stop();
        EXPECT_EQ(log.text(), "");
    }
    EXPECT_TRUE(log.contains("careless")) << log.text();
}

TEST_F(ComponentLog, SaysNothingIfNoThreadExecutesWhatIsDestroyed) {
    {
        TaskContext driven("driven");
        ASSERT_TRUE(driven.setActivity(new extras::SequentialActivity()));
        ASSERT_TRUE(driven.start());
    }
    EXPECT_EQ(log.text(), "");
}

TEST_F(ComponentLog, TellsWhyTheActivityStays) {
    ASSERT_TRUE(c.configure() && c.start());
    EXPECT_FALSE(c.setActivity(new extras::SlaveActivity()));
    expect({"gripper", "activity", "running"});
}

TEST_F(ComponentLog, TellsOfWhatIsNotConnectedAtLevelDebug) {
    const Logger::LogLevel before = Logger::Instance()->getLogLevel();
    Probe other("other");
    OutputPort<int> missing("missing"), same("same"), alsoSame("same");
    OperationCaller<void()> op("op");
    c.addPort(missing);
    c.addPort(same);
    other.addPort(alsoSame);
    c.requires_("service")->addOperationCaller(op);
    EXPECT_TRUE(c.connectPorts(&other) && c.connectServices(&other));
    EXPECT_EQ(log.text(), "");
    Logger::Instance()->setLogLevel(Logger::Debug);
    EXPECT_TRUE(c.connectPorts(&other) && c.connectServices(&other));
    Logger::Instance()->setLogLevel(before);
    for (const char* part : {"'missing'", "'same'", "'service'"})
        EXPECT_TRUE(log.contains(part)) << part << " is not in: " << log.text();
}

}  // namespace
