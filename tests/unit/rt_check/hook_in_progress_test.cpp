// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What the runtime tells of whose code a thread executes, and which threads were meant to be real-time threads.
#include <rtt/Activity.hpp>
#include <rtt/Operation.hpp>
#include <rtt/OperationCaller.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/internal/engine/hook_in_progress.hpp>
#include <rtt/os/MainThread.hpp>
#include <rtt/os/real_time_wanted.hpp>

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

using namespace RTT;
using internal::HookInProgress;

namespace {

/** "component.hook in component.hook", the innermost first. */
std::string here() {
    std::string text;
    for (const HookInProgress* hook = HookInProgress::innermost(); hook; hook = hook->outer)
        text += (text.empty() ? "" : " in ") + std::string(hook->component) + "." + hook->hook;
    return text;
}

struct Telling : TaskContext {
    explicit Telling(const std::string& name) : TaskContext(name, PreOperational) {
        setActivity(new extras::SlaveActivity);
        addOperation("ask", &Telling::ask, this, OwnThread);
    }
    ~Telling() override { stop(); }
    bool configureHook() override { return tell(); }
    bool startHook() override { return tell(); }
    void updateHook() override {
        tell();
        if (inner) inner->update();
        if (throws) throw std::runtime_error("as wanted");
        tell();
    }
    void errorHook() override { tell(); }
    void stopHook() override { tell(); }
    void cleanupHook() override { tell(); }
    void exceptionHook() override { tell(); }
    void ask() { tell(); }
    bool tell() {
        told.push_back(here());
        EXPECT_EQ(this, HookInProgress::innermost()->task);
        return true;
    }
    std::vector<std::string> told;
    TaskContext* inner = nullptr;
    bool throws = false;
};

using Texts = std::vector<std::string>;

TEST(HookInProgress, TellsTheHookOfAComponent) {
    Telling a("a");
    EXPECT_EQ(nullptr, HookInProgress::innermost());
    ASSERT_TRUE(a.configure() && a.start() && a.update());
    a.error();
    ASSERT_TRUE(a.update() && a.stop() && a.cleanup());
    EXPECT_EQ((Texts{"a.configureHook()", "a.startHook()", "a.updateHook()", "a.updateHook()", "a.errorHook()",
                     "a.stopHook()", "a.cleanupHook()"}),
              a.told);
    EXPECT_EQ(nullptr, HookInProgress::innermost());
}

TEST(HookInProgress, Nests) {
    Telling outer("outer"), inner("inner");
    ASSERT_TRUE(inner.configure() && inner.start() && outer.configure() && outer.start());
    outer.inner = &inner;
    inner.told.clear();
    outer.told.clear();
    ASSERT_TRUE(outer.update());
    EXPECT_EQ((Texts{"outer.updateHook()", "outer.updateHook()"}), outer.told);
    EXPECT_EQ(Texts(2, "inner.updateHook() in outer.updateHook()"), inner.told);
}

TEST(HookInProgress, EndsWithAnException) {
    Telling a("a");
    ASSERT_TRUE(a.configure() && a.start());
    a.throws = true;
    a.told.clear();
    a.update();
    EXPECT_TRUE(a.inException());
    EXPECT_EQ((Texts{"a.updateHook()", "a.stopHook()", "a.cleanupHook()", "a.exceptionHook()"}), a.told);
    EXPECT_EQ(nullptr, HookInProgress::innermost());
}

TEST(HookInProgress, TellsOfMessages) {
    Telling a("a"), b("b");
    OperationCaller<void()> ask(a.getOperation("ask"), b.engine());
    ask.send();
    ASSERT_TRUE(a.update());
    EXPECT_EQ(Texts{"a.a message"}, a.told);
}

TEST(HookInProgress, MayStandForAComponentThatDoesNotExistYet) {
    const HookInProgress hook("soon", "its constructor");
    EXPECT_EQ("soon.its constructor", here());
    EXPECT_EQ(nullptr, hook.task);
}

std::string watched;
const internal::HookWatch kWatch = {[](const HookInProgress& hook) { watched += std::string("+") + hook.hook; },
                                    [](const HookInProgress& hook) { watched += std::string("-") + hook.hook; }};

TEST(HookInProgress, AWatchIsToldOfBeginAndEndInPairs) {
    Telling a("a");
    ASSERT_TRUE(a.configure() && a.start());
    {
        const HookInProgress before("x", "before");
        HookInProgress::setWatch(&kWatch);
        a.update();
    }
    const auto* const open = new HookInProgress("x", "open");
    HookInProgress::setWatch(nullptr);
    delete open;
    a.update();
    EXPECT_EQ("+updateHook()-updateHook()+open-open", watched);
}

TEST(RealTimeWanted, IsWhatWasAskedFor) {
    Activity realTime(ORO_SCHED_RT, 10, 0.1, nullptr, "real_time"), other(ORO_SCHED_OTHER, 0, 0.1, nullptr, "other");
    EXPECT_TRUE(os::realTimeWanted(realTime));  // whether or not it was granted
    EXPECT_FALSE(os::realTimeWanted(other));
    EXPECT_FALSE(os::realTimeWanted(*os::MainThread::Instance()));
}

TEST(RealTimeWanted, ChangesWithTheScheduler) {
    Activity activity(ORO_SCHED_OTHER, 0, 0.1, nullptr, "a");
    activity.setScheduler(ORO_SCHED_RT);
    EXPECT_TRUE(os::realTimeWanted(activity));
    EXPECT_TRUE(activity.setScheduler(ORO_SCHED_OTHER));
    EXPECT_FALSE(os::realTimeWanted(activity));
    EXPECT_FALSE(activity.setScheduler(77));
    EXPECT_FALSE(os::realTimeWanted(activity));
}

TEST(RealTimeWanted, IsNotInheritedWithTheNumber) {
    int number = -1;
    {
        Activity realTime(ORO_SCHED_RT, 10, 0.1, nullptr, "real_time");
        number = realTime.threadNumber();
    }
    Activity other(ORO_SCHED_OTHER, 0, 0.1, nullptr, "other");
    EXPECT_EQ(number, other.threadNumber());
    EXPECT_FALSE(os::realTimeWanted(other));
}

}  // namespace
