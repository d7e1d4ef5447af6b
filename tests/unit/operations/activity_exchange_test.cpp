// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// How a component treats the activities it is given.
#include "probe.hpp"

#include <rtt/Activity.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/internal/GlobalEngine.hpp>

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::Probe;

namespace {

/** Writes down what is done to it. */
struct Recording : base::ActivityInterface {
    Recording(std::string& text, const std::string& name, bool starts = true)
        : text_(text), name_(name), starts_(starts) {}
    ~Recording() override {
        closeGate();
        note("destroyed");
    }
    bool run(base::RunnableInterface* r) override { return note(r ? "run" : "detach"), ActivityInterface::run(r); }
    bool start() override { return note("start"), active_ = starts_; }
    bool stop() override {
        if (active_) note("stop");
        return std::exchange(active_, false);
    }
    bool isRunning() const override { return false; }
    bool isActive() const override { return active_; }
    Seconds getPeriod() const override { return 0; }
    bool setPeriod(Seconds) override { return false; }
    unsigned getCpuAffinity() const override { return ~0u; }
    bool setCpuAffinity(unsigned) override { return false; }
    bool execute() override { return false; }
    bool trigger() override { return active_; }
    bool timeout() override { return active_; }
    os::ThreadInterface* thread() override { return nullptr; }
    bool isSelf() const override { return false; }

private:
    void note(const char* what) { text_ += name_ + "." + what + " "; }
    std::string& text_;
    const std::string name_;
    const bool starts_;
    bool active_ = false;
};

TEST(ExchangedActivity, NewOneIsStoppedAndStartedAndOldOneStoppedAndDestroyed) {
    std::string text;
    {
        TaskContext c("c");
        ASSERT_TRUE(c.setActivity(new Recording(text, "a")));
        EXPECT_EQ(text, "a.run a.start ");
        text.clear();
        auto* const next = new Recording(text, "b");
        ASSERT_TRUE(next->start());
        ASSERT_TRUE(c.setActivity(next));
        EXPECT_EQ(text, "b.start a.stop b.stop b.run a.detach a.destroyed b.start ");
        EXPECT_EQ(c.getActivity(), next);
        text.clear();
    }
    EXPECT_NE(text.find("b.stop "), std::string::npos);
    EXPECT_NE(text.find("b.destroyed "), std::string::npos) << "the component owns it";
}

TEST(ExchangedActivity, ThatDoesNotStartIsTakenAllTheSame) {
    std::string text;
    TaskContext c("c");
    auto* const lame = new Recording(text, "a", false);
    EXPECT_TRUE(c.setActivity(lame));
    EXPECT_EQ(c.getActivity(), lame);
    EXPECT_FALSE(c.isActive());
}

TEST(ExchangedActivity, PresentOneIsNotExchanged) {
    std::string text;
    TaskContext c("c");
    auto* const activity = new Recording(text, "a");
    ASSERT_TRUE(c.setActivity(activity));
    text.clear();
    EXPECT_TRUE(c.setActivity(activity));
    EXPECT_EQ(text, "");
    EXPECT_TRUE(c.isActive());
}

TEST(ExchangedActivity, ConfigureHookMayGiveTheComponentAnother) {
    Probe c("c", TaskContext::PreOperational);
    c.onConfigure = [&] { return c.setActivity(new Activity(ORO_SCHED_OTHER, 0, 1000.0, c.engine(), "own")); };
    EXPECT_TRUE(c.configure());
    EXPECT_EQ(c.getPeriod(), 1000.0);
    EXPECT_STREQ(c.getActivity<Activity>()->getName(), "own");
    EXPECT_TRUE(c.isActive());
    EXPECT_TRUE(c.start());
}

// When the hook is executed by the thread that it wants to take away.
TEST(ExchangedActivity, ConfigureHookInTheOwnThreadIsRefusedOne) {
    Probe c("c", TaskContext::PreOperational);
    base::ActivityInterface* const before = c.getActivity();
    c.onConfigure = [&] { return c.setActivity(new extras::SequentialActivity()); };
    c.addOperation(
        "setup", [&] { return c.configure(); }, OwnThread);
    EXPECT_FALSE(OperationCaller<bool()>(c.getOperation("setup"), internal::GlobalEngine::Instance())());
    EXPECT_EQ(c.getActivity(), before);
    EXPECT_EQ(c.getTaskState(), TaskContext::PreOperational);
}

struct Forcing : Probe {
    Forcing() : Probe("forcing") {}
    using TaskContext::forceActivity;
};

TEST(ForcedActivity, IsExchangedWhileRunning) {
    std::string text;
    Forcing c;
    ASSERT_TRUE(c.start());
    auto* const activity = new Recording(text, "a");
    EXPECT_FALSE(c.setActivity(new Recording(text, "b")));
    EXPECT_EQ(text, "b.destroyed ");
    text.clear();
    c.forceActivity(activity);
    EXPECT_EQ(c.getActivity(), activity);
    EXPECT_EQ(text, "a.run a.start ");
    EXPECT_TRUE(c.isRunning());
    c.forceActivity(nullptr);
    EXPECT_EQ(c.getActivity(), activity) << "null is ignored";
    EXPECT_TRUE(c.stop());
}

}  // namespace
