// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What an activity says of itself in initialize() and finalize().
#include "os_test.hpp"

#include <rtt/extras/Activities.hpp>

#include <stdexcept>

using namespace RTT;
using oroforge::test::eventually;

namespace {

struct AskingRunner : base::RunnableInterface {
    base::ActivityInterface* activity = nullptr;
    std::function<bool()> onInitialize;
    std::function<void()> onFinalize;
    std::atomic<int> whenInitialized{-1}, whenFinalized{-1};
    bool initialize() override {
        whenInitialized = activity->isActive();
        return !onInitialize || onInitialize();
    }
    void step() override {}
    bool breakLoop() override { return true; }
    void finalize() override {
        whenFinalized = activity->isActive();
        if (onFinalize) onFinalize();
    }
};

/** Activities without a thread of their own. */
template <class Kind>
struct ActiveInHooks : testing::Test {
    AskingRunner r;
    Kind a{&r};
    ActiveInHooks() { r.activity = &a; }
};
using Kinds = testing::Types<extras::SequentialActivity, extras::SlaveActivity>;
TYPED_TEST_SUITE(ActiveInHooks, Kinds);

TYPED_TEST(ActiveInHooks, IsActiveInInitializeAndFinalize) {
    for (int round = 0; round != 2; ++round) {
        ASSERT_TRUE(this->a.start());
        EXPECT_EQ(this->r.whenInitialized.exchange(-1), 1);
        EXPECT_TRUE(this->a.isActive());
        EXPECT_TRUE(this->a.stop());
        EXPECT_EQ(this->r.whenFinalized.exchange(-1), 1);
        EXPECT_FALSE(this->a.isActive());
    }
}

TYPED_TEST(ActiveInHooks, IsNotActiveAfterInitializeHasRefused) {
    this->r.onInitialize = [] { return false; };
    EXPECT_FALSE(this->a.start());
    EXPECT_FALSE(this->a.isActive());
    EXPECT_FALSE(this->a.stop());
    this->r.onInitialize = nullptr;
    EXPECT_TRUE(this->a.start());
}

TYPED_TEST(ActiveInHooks, IsNotActiveAfterOneOfThemHasThrown) {
    this->r.onInitialize = []() -> bool { throw std::runtime_error("initialize"); };
    EXPECT_THROW(this->a.start(), std::runtime_error);
    EXPECT_FALSE(this->a.isActive());
    this->r.onInitialize = nullptr;
    ASSERT_TRUE(this->a.start());
    this->r.onFinalize = [] { throw std::runtime_error("finalize"); };
    EXPECT_THROW(this->a.stop(), std::runtime_error);
    EXPECT_FALSE(this->a.isActive());
    this->r.onFinalize = nullptr;
    EXPECT_TRUE(this->a.start());
}

TYPED_TEST(ActiveInHooks, ExecutesNothingInThem) {
    this->r.onInitialize = [this] { return !this->a.trigger() && !this->a.execute(); };
    this->r.onFinalize = [this] {
        EXPECT_FALSE(this->a.trigger());
        EXPECT_FALSE(this->a.execute());
        EXPECT_FALSE(this->a.start());
        EXPECT_FALSE(this->a.stop());
    };
    ASSERT_TRUE(this->a.start());
    EXPECT_TRUE(this->a.stop());
    EXPECT_FALSE(this->a.isActive());
}

template <class Kind, class... Arguments>
void expectActiveInFinalize(Arguments... arguments) {
    AskingRunner r;
    Kind a(arguments..., &r);
    r.activity = &a;
    ASSERT_TRUE(a.start());
    EXPECT_TRUE(eventually([&] { return a.stop(); }));
    EXPECT_EQ(r.whenFinalized, 1);
    EXPECT_FALSE(a.isActive());
}

TEST(ActiveInFinalize, IsEveryActivity) {
    expectActiveInFinalize<Activity>(ORO_SCHED_OTHER, 0);
    expectActiveInFinalize<Activity>(ORO_SCHED_OTHER, 0, 0.002);
    expectActiveInFinalize<extras::PeriodicActivity>(ORO_SCHED_OTHER, 0, 0.002);
    expectActiveInFinalize<extras::FileDescriptorActivity>(ORO_SCHED_OTHER, 0);
    expectActiveInFinalize<extras::SimulationActivity>(0.001);
    extras::SimulationThread::Release();
}

}  // namespace
