// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The state machine of a component: every call from every state, and what hooks can do to it.
#include "probe.hpp"

#include <ostream>
#include <stdexcept>

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::Probe;

namespace {

typedef TaskContext::TaskState State;
constexpr State kPreOperational = TaskContext::PreOperational;
constexpr State kFatal = TaskContext::FatalError;
constexpr State kException = TaskContext::Exception;
constexpr State kStopped = TaskContext::Stopped;
constexpr State kRunning = TaskContext::Running;
constexpr State kRunTimeError = TaskContext::RunTimeError;

const char* nameOf(State state) {
    static const char* const names[] = {"Init",    "PreOperational", "FatalError",  "Exception",
                                        "Stopped", "Running",        "RunTimeError"};
    return names[state];
}

/** Brings a component that was constructed PreOperational into a state. */
void bringTo(Probe& probe, State state) {
    if (state == kFatal) probe.fatal();
    if (state == kException) probe.exception();
    if (state >= kStopped) {
        ASSERT_TRUE(probe.configure());
    }
    if (state >= kRunning) {
        ASSERT_TRUE(probe.start());
    }
    if (state == kRunTimeError) probe.error();
    ASSERT_EQ(probe.getTaskState(), state);
    probe.takeHooks();
}

bool act(Probe& probe, const std::string& call) {
    if (call == "configure") return probe.configure();
    if (call == "start") return probe.start();
    if (call == "stop") return probe.stop();
    if (call == "cleanup") return probe.cleanup();
    if (call == "recover") return probe.recover();
    if (call == "activate") return probe.activate();
    if (call == "error") return probe.error(), true;
    if (call == "exception") return probe.exception(), true;
    if (call == "fatal") return probe.fatal(), true;
    ADD_FAILURE() << "no such call: " << call;
    return false;
}

struct Transition {
    State from;
    const char* call;
    bool result;
    State to;
    const char* hooks;
};
std::ostream& operator<<(std::ostream& os, const Transition& t) { return os << nameOf(t.from) << "." << t.call; }

class LifeCycle : public testing::TestWithParam<Transition> {};

TEST_P(LifeCycle, TransitionOfComponentConstructedPreOperational) {
    const Transition& t = GetParam();
    Probe probe("probe", kPreOperational);
    bringTo(probe, t.from);

    EXPECT_EQ(act(probe, t.call), t.result);

    EXPECT_STREQ(nameOf(probe.getTaskState()), nameOf(t.to));
    EXPECT_STREQ(nameOf(probe.getTargetState()), nameOf(t.to));
    EXPECT_EQ(probe.takeHooks(), t.hooks);
    EXPECT_EQ(probe.isConfigured(), t.to >= kStopped);
    EXPECT_EQ(probe.isRunning(), t.to >= kRunning);
    EXPECT_EQ(probe.inException(), t.to == kException);
    EXPECT_EQ(probe.inFatalError(), t.to == kFatal);
    EXPECT_EQ(probe.inRunTimeError(), t.to == kRunTimeError);
}

const Transition kTable[] = {
    {kPreOperational, "configure", true, kStopped, "configure"},
    {kPreOperational, "start", false, kPreOperational, ""},
    {kPreOperational, "stop", false, kPreOperational, ""},
    {kPreOperational, "cleanup", false, kPreOperational, ""},
    {kPreOperational, "recover", false, kPreOperational, ""},
    {kPreOperational, "error", true, kPreOperational, ""},
    {kPreOperational, "activate", true, kPreOperational, ""},
    {kPreOperational, "exception", true, kException, "exception"},
    {kPreOperational, "fatal", true, kFatal, ""},

    {kStopped, "configure", true, kStopped, "configure"},
    {kStopped, "start", true, kRunning, "start"},
    {kStopped, "stop", false, kStopped, ""},
    {kStopped, "cleanup", true, kPreOperational, "cleanup"},
    {kStopped, "recover", false, kStopped, ""},
    {kStopped, "error", true, kStopped, ""},
    {kStopped, "activate", true, kStopped, ""},
    {kStopped, "exception", true, kException, "cleanup exception"},
    {kStopped, "fatal", true, kFatal, ""},

    {kRunning, "configure", false, kRunning, ""},
    {kRunning, "start", false, kRunning, ""},
    {kRunning, "stop", true, kStopped, "stop"},
    {kRunning, "cleanup", false, kRunning, ""},
    {kRunning, "recover", false, kRunning, ""},
    {kRunning, "error", true, kRunTimeError, ""},
    {kRunning, "activate", true, kRunning, ""},
    {kRunning, "exception", true, kException, "stop cleanup exception"},
    {kRunning, "fatal", true, kFatal, ""},

    {kRunTimeError, "configure", false, kRunTimeError, ""},
    {kRunTimeError, "start", false, kRunTimeError, ""},
    {kRunTimeError, "stop", true, kStopped, "stop"},
    {kRunTimeError, "cleanup", false, kRunTimeError, ""},
    {kRunTimeError, "recover", true, kRunning, ""},
    {kRunTimeError, "error", true, kRunTimeError, ""},
    {kRunTimeError, "activate", true, kRunTimeError, ""},
    {kRunTimeError, "exception", true, kException, "stop cleanup exception"},
    {kRunTimeError, "fatal", true, kFatal, ""},

    {kException, "configure", false, kException, ""},
    {kException, "start", false, kException, ""},
    {kException, "stop", false, kException, ""},
    {kException, "cleanup", false, kException, ""},
    {kException, "recover", true, kPreOperational, ""},
    {kException, "error", true, kException, ""},
    {kException, "activate", true, kException, ""},
    {kException, "fatal", true, kFatal, ""},

    {kFatal, "configure", false, kFatal, ""},
    {kFatal, "start", false, kFatal, ""},
    {kFatal, "stop", false, kFatal, ""},
    {kFatal, "cleanup", false, kFatal, ""},
    {kFatal, "recover", false, kFatal, ""},
    {kFatal, "error", true, kFatal, ""},
    {kFatal, "exception", true, kFatal, ""},
};
INSTANTIATE_TEST_SUITE_P(Table, LifeCycle, testing::ValuesIn(kTable),
                         [](const auto& info) { return std::string(nameOf(info.param.from)) + "_" + info.param.call; });

TEST(LifeCycleStart, IsStoppedByDefaultAndActive) {
    Probe probe;
    EXPECT_EQ(probe.getTaskState(), kStopped);
    EXPECT_TRUE(probe.isActive());
    EXPECT_EQ(probe.takeHooks(), "");
}

TEST(LifeCycleRecover, KeepsTheConfigurationOfAComponentConstructedStopped) {
    Probe probe;
    ASSERT_TRUE(probe.start());
    probe.exception();
    EXPECT_EQ(probe.takeHooks(), "start stop exception")
        << "cleanupHook() is for components that were constructed PreOperational";
    EXPECT_TRUE(probe.recover());
    EXPECT_EQ(probe.getTaskState(), kStopped);
}

TEST(LifeCycleRefusal, FailedConfigurationLeadsToPreOperationalAlsoFromStopped) {
    Probe probe;
    probe.onConfigure = [] { return false; };
    EXPECT_FALSE(probe.configure());
    EXPECT_EQ(probe.getTaskState(), kPreOperational);
    EXPECT_EQ(probe.getTargetState(), kPreOperational);
}

TEST(LifeCycleRefusal, FailedStartStaysStopped) {
    Probe probe;
    probe.onStart = [] { return false; };
    EXPECT_FALSE(probe.start());
    EXPECT_EQ(probe.getTaskState(), kStopped);
    EXPECT_EQ(probe.getTargetState(), kStopped);
    EXPECT_EQ(probe.takeHooks(), "start");
}

struct Throwing {
    const char* hook;
    State from;
    const char* call;
    State to;
    const char* hooks;
};
std::ostream& operator<<(std::ostream& os, const Throwing& t) { return os << t.hook; }

class HookThrows : public testing::TestWithParam<Throwing> {};

// No hook is called a second time because it threw: cleanupHook() at most once per configuration.
TEST_P(HookThrows, LeadsToExceptionOnce) {
    const Throwing& t = GetParam();
    Probe probe("probe", kPreOperational);
    bringTo(probe, t.from);
    const std::string hook = t.hook;
    const auto fail = [] { throw std::runtime_error("planted"); };
    if (hook == "configure") probe.onConfigure = [&] { return fail(), true; };
    if (hook == "start") probe.onStart = [&] { return fail(), true; };
    if (hook == "stop") probe.onStop = fail;
    if (hook == "cleanup") probe.onCleanup = fail;
    if (hook == "exception") probe.onException = fail;

    if (std::string(t.call) != "exception") {
        EXPECT_FALSE(act(probe, t.call));
    } else {
        act(probe, t.call);
    }

    EXPECT_STREQ(nameOf(probe.getTaskState()), nameOf(t.to));
    EXPECT_EQ(probe.takeHooks(), t.hooks);
}

const Throwing kThrowing[] = {
    {"configure", kPreOperational, "configure", kException, "configure exception"},
    {"configure", kStopped, "configure", kException, "configure cleanup exception"},
    {"start", kStopped, "start", kException, "start cleanup exception"},
    {"stop", kRunning, "stop", kException, "stop cleanup exception"},
    {"cleanup", kStopped, "cleanup", kException, "cleanup exception"},
    {"exception", kStopped, "exception", kFatal, "cleanup exception"},
};
INSTANTIATE_TEST_SUITE_P(Table, HookThrows, testing::ValuesIn(kThrowing),
                         [](const auto& info) { return nameOf(info.param.from) + std::string("_") + info.param.hook; });

TEST(HookThrowsWithinException, StopHookThatThrowsThereLeadsToFatalError) {
    Probe probe("probe", kPreOperational);
    bringTo(probe, kRunning);
    probe.onStop = [] { throw 42; };
    probe.exception();
    EXPECT_EQ(probe.getTaskState(), kFatal);
    EXPECT_FALSE(probe.isActive());
}

TEST(HookThrowsInStep, UpdateHookThatThrowsLeadsToException) {
    Probe probe("probe", kPreOperational);
    ASSERT_TRUE(probe.configure());
    probe.onUpdate = [] { throw std::runtime_error("planted"); };
    ASSERT_TRUE(probe.start());
    EXPECT_TRUE(eventually([&] { return probe.inException(); }));
    std::string hooks;
    EXPECT_TRUE(eventually([&] { return (hooks += probe.takeHooks() + " ").find("exception") != std::string::npos; }));
    EXPECT_EQ(hooks.substr(0, 15), "configure start") << hooks;
    EXPECT_TRUE(probe.isActive()) << "the thread goes on: operations are still executed";
}

TEST(HookThrowsInStep, ErrorHookThatThrowsLeadsToException) {
    Probe probe;
    probe.onUpdate = [&] { probe.error(); };
    probe.onError = [] { throw 42; };
    ASSERT_TRUE(probe.start());
    EXPECT_TRUE(eventually([&] { return probe.inException(); }));
}

TEST(HookContradicts, ConfigureHookThatCallsExceptionAndReturnsTrueIsAnException) {
    Probe probe("probe", kPreOperational);
    probe.onConfigure = [&] { return probe.exception(), true; };
    EXPECT_FALSE(probe.configure());
    EXPECT_TRUE(probe.inException());
}

TEST(HookContradicts, StartHookThatCallsExceptionAndReturnsFalseStaysInException) {
    Probe probe;
    probe.onStart = [&] { return probe.exception(), false; };
    EXPECT_FALSE(probe.start());
    EXPECT_TRUE(probe.inException());
}

TEST(RunTimeError, ErrorHookTakesThePlaceOfUpdateHookFromTheSameStepOn) {
    Probe probe;
    probe.onUpdate = [&] { probe.error(); };
    ASSERT_TRUE(probe.start());
    ASSERT_TRUE(eventually([&] { return probe.errors == 1; }));
    EXPECT_EQ(probe.updates, 1);
    ASSERT_TRUE(probe.trigger());
    ASSERT_TRUE(eventually([&] { return probe.errors == 2; }));
    EXPECT_EQ(probe.updates, 1);
    probe.onUpdate = nullptr;
    EXPECT_TRUE(probe.recover());
    ASSERT_TRUE(probe.trigger());
    EXPECT_TRUE(eventually([&] { return probe.updates == 2; }));
}

TEST(Hooks, AllowEverythingAndDoNothingByDefault) {
    struct Plain : TaskContext {
        Plain() : TaskContext("plain", kPreOperational) { setActivity(new extras::SlaveActivity()); }
        using TaskContext::breakUpdateHook;
        using TaskContext::exception;
        void updateHook() override { ++updates; }
        int updates = 0;
    } plain;
    EXPECT_TRUE(plain.breakUpdateHook());
    ASSERT_TRUE(plain.configure() && plain.start() && plain.update());
    EXPECT_EQ(plain.updates, 1);
    plain.error();
    ASSERT_TRUE(plain.update());
    EXPECT_EQ(plain.updates, 1) << "errorHook() does not call updateHook()";
    EXPECT_TRUE(plain.recover() && plain.update());
    EXPECT_EQ(plain.updates, 2);
    EXPECT_TRUE(plain.stop() && plain.cleanup());
    plain.exception();
    EXPECT_TRUE(plain.inException());
}

TEST(Stop, WaitsForTheStepThatIsExecuting) {
    Probe probe;
    std::atomic<bool> entered{false}, left{false};
    probe.onUpdate = [&] {
        entered = true;
        usleep(20000);
        left = true;
    };
    ASSERT_TRUE(probe.start());
    ASSERT_TRUE(eventually([&] { return entered.load(); }));
    EXPECT_TRUE(probe.stop());
    EXPECT_TRUE(left);
    EXPECT_TRUE(probe.isActive()) << "the thread goes on";
}

TEST(Stop, FromTheOwnUpdateHook) {
    Probe probe;
    std::atomic<int> result{-1};
    probe.onUpdate = [&] { result = probe.stop(); };
    ASSERT_TRUE(probe.start());
    ASSERT_TRUE(eventually([&] { return result != -1; }));
    EXPECT_EQ(result, 1);
    EXPECT_TRUE(eventually([&] { return probe.getTaskState() == kStopped; }));
    probe.onUpdate = nullptr;
    EXPECT_TRUE(probe.start());
    EXPECT_TRUE(eventually([&] { return probe.updates >= 2; }));
}

TEST(Stop, SucceedsThoughTheLastStepCalledError) {
    Probe probe;
    std::atomic<bool> entered{false};
    probe.onUpdate = [&] {
        entered = true;
        usleep(20000);
        probe.error();
    };
    ASSERT_TRUE(probe.start());
    ASSERT_TRUE(eventually([&] { return entered.load(); }));
    EXPECT_TRUE(probe.stop());
    EXPECT_EQ(probe.getTaskState(), kStopped);
}

TEST(Fatal, StopsTheActivityForGood) {
    Probe probe;
    ASSERT_TRUE(probe.start());
    probe.fatal();
    EXPECT_FALSE(probe.isActive());
    EXPECT_FALSE(probe.start());
    EXPECT_FALSE(probe.recover());
}

}  // namespace
