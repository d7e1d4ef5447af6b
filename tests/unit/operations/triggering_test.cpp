// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Which event leads to which kind of step, and so to updateHook() or not.
#include "probe.hpp"

#include <rtt/Activity.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/extras/FileDescriptorActivity.hpp>
#include <rtt/internal/GlobalEngine.hpp>

#include <sys/eventfd.h>

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::Note;
using oroforge::test::Probe;
using oroforge::test::Steps;

namespace {

constexpr Seconds kNotPeriodic = 0.0, kEndlessPeriod = 1000.0;

/** Counts the steps by their reason. */
struct Counting : Activity {
    explicit Counting(Seconds period) : Activity(ORO_SCHED_OTHER, 0, period) {}
    ~Counting() override { stop(); }
    void work(base::RunnableInterface::WorkReason reason) override {
        ++(reason == base::RunnableInterface::Trigger ? triggers : timeouts);
        Activity::work(reason);
    }
    std::atomic<int> triggers{0}, timeouts{0};
};

/** A component that notes all that a step consists of; its function is executed in every full step. */
struct Triggering : testing::TestWithParam<Seconds> {
    Triggering() {
        c.onUpdate = [this] { c.note("update"); };
        c.addEventPort("wake", wake);
        c.addEventPort("called", called, [this](base::PortInterface*) { c.note("callback"); });
        c.addOperation(
            "op", [this] { c.note("op"); }, OwnThread);
        Attribute<bool>(c.getAttribute("TriggerOnStart")).set(false);
    }
    ~Triggering() override {
        c.stop();
        c.getActivity()->stop();
        c.engine()->removeFunction(&function);
    }

    void useActivity(Seconds period) {
        activity = new Counting(period);
        ASSERT_TRUE(c.setActivity(activity));
        ASSERT_TRUE(c.engine()->runFunction(&function));
        settle();
    }
    /** Nothing that was asked for before this is left to be done. */
    void settle() {
        for (int i = 0; i != 2; ++i) {
            Note last;
            ASSERT_TRUE(c.engine()->process(&last));
            ASSERT_TRUE(eventually([&] { return last.executed == 1; }));
        }
    }
    std::string takeHooks() {
        settle();
        return c.takeHooks();
    }
    void run(Seconds period) {
        useActivity(period);
        ASSERT_TRUE(c.start());
        EXPECT_EQ(takeHooks(), "start");
        EXPECT_EQ(activity->timeouts, 0);
    }

    Probe c;
    Counting* activity = nullptr;
    InputPort<int> wake, called;
    OutputPort<int> out{"out"};
    Steps function{[this] { return c.note("function"), true; }};
};

TEST_F(Triggering, EndOfAPeriodIsAFullStep) {
    useActivity(0.001);
    ASSERT_TRUE(c.start());
    ASSERT_TRUE(eventually([&] { return c.updates >= 3; }));
    ASSERT_TRUE(c.stop());
    EXPECT_GE(activity->timeouts, 3);
    EXPECT_NE(c.takeHooks().find("function update function update function update"), std::string::npos);
}

TEST_F(Triggering, TriggerIsAFullStepOfAComponentThatIsNotPeriodic) {
    run(kNotPeriodic);
    EXPECT_TRUE(c.trigger());
    EXPECT_EQ(takeHooks(), "function update");
    EXPECT_EQ(activity->timeouts, 1);
}

TEST_F(Triggering, TriggerIsRefusedByAPeriodicComponent) {
    run(kEndlessPeriod);
    EXPECT_FALSE(c.trigger());
    EXPECT_EQ(takeHooks(), "");
    EXPECT_EQ(activity->timeouts, 0);
}

TEST_F(Triggering, StartIsATriggerUnlessItIsSwitchedOff) {
    useActivity(kNotPeriodic);
    Attribute<bool>(c.getAttribute("TriggerOnStart")).set(true);
    ASSERT_TRUE(c.start());
    EXPECT_EQ(takeHooks(), "start function update");
    EXPECT_EQ(activity->timeouts, 1);
}

TEST_F(Triggering, StartDoesNotStartTheActivity) {
    useActivity(kNotPeriodic);
    Attribute<bool>(c.getAttribute("TriggerOnStart")).set(true);
    ASSERT_TRUE(c.getActivity()->stop());
    EXPECT_TRUE(c.start());
    EXPECT_TRUE(c.isRunning());
    EXPECT_FALSE(c.isActive());
    EXPECT_EQ(c.takeHooks(), "start");
    EXPECT_TRUE(c.activate());
    EXPECT_TRUE(eventually([&] { return c.updates == 1; })) << "the trigger was kept";
    ASSERT_TRUE(c.getActivity()->stop());
    EXPECT_TRUE(c.stop()) << "there is nothing to wait for";
    EXPECT_FALSE(c.isActive());
}

TEST_P(Triggering, SentOperationIsExecutedAtOnceWithoutUpdate) {
    run(GetParam());
    EXPECT_NO_THROW(OperationCaller<void()>(c.getOperation("op"), internal::GlobalEngine::Instance())());
    EXPECT_EQ(takeHooks(), "op");
    EXPECT_EQ(activity->timeouts, 0);
}

TEST_P(Triggering, NewDataOnAPortWithCallbackCallsItWithoutUpdate) {
    run(GetParam());
    ASSERT_TRUE(out.connectTo(&called));
    out.write(1);
    EXPECT_EQ(takeHooks(), "callback");
    EXPECT_EQ(activity->timeouts, 0);
}

TEST_F(Triggering, NewDataOnAPortWithoutCallbackIsATrigger) {
    run(kNotPeriodic);
    ASSERT_TRUE(out.connectTo(&wake));
    out.write(1);
    EXPECT_EQ(takeHooks(), "function update");
    EXPECT_EQ(activity->timeouts, 1);
}

TEST_F(Triggering, NewDataOnAPortWithoutCallbackAddsNothingToAPeriod) {
    run(kEndlessPeriod);
    const int before = activity->triggers;
    ASSERT_TRUE(out.connectTo(&wake));
    out.write(1);
    EXPECT_TRUE(eventually([&] { return activity->triggers > before; }));
    EXPECT_EQ(takeHooks(), "");
    EXPECT_EQ(activity->timeouts, 0);
}

TEST_P(Triggering, NewDataOfAComponentThatIsNotRunningIsKeptButNotAnnounced) {
    useActivity(GetParam());
    ASSERT_TRUE(out.connectTo(&wake));
    ASSERT_TRUE(out.connectTo(&called));
    out.write(7);
    EXPECT_EQ(takeHooks(), "");
    ASSERT_TRUE(c.start());
    EXPECT_EQ(takeHooks(), "start") << "nor announced later";
    int value = 0;
    EXPECT_EQ(wake.read(value), NewData);
    EXPECT_EQ(value, 7);
    EXPECT_EQ(called.read(value), NewData);
}

TEST_P(Triggering, FunctionWaitsForTheNextFullStep) {
    run(GetParam());
    Steps late([this] { return c.note("late"), false; });
    ASSERT_TRUE(c.engine()->runFunction(&late));
    EXPECT_EQ(takeHooks(), "");
    EXPECT_TRUE(late.isLoaded());
    c.engine()->removeFunction(&late);
    EXPECT_FALSE(late.isLoaded());
}

TEST_F(Triggering, FunctionsThatAFunctionAddsWaitForTheNextStep) {
    run(kNotPeriodic);
    Steps second([this] { return c.note("second"), false; });
    Steps first([&] { return c.engine()->runFunction(&second), false; });
    ASSERT_TRUE(c.engine()->runFunction(&first));
    EXPECT_TRUE(c.trigger());
    EXPECT_EQ(takeHooks(), "function update");
    EXPECT_TRUE(c.trigger());
    EXPECT_EQ(takeHooks(), "function second update");
}

TEST_F(Triggering, SetPeriodIsATriggerOfTheActivity) {
    run(kNotPeriodic);
    for (const Seconds period : {kEndlessPeriod, kNotPeriodic}) {
        const int before = activity->triggers;
        ASSERT_TRUE(c.setPeriod(period));
        EXPECT_TRUE(eventually([&] { return activity->triggers > before; }));
        EXPECT_EQ(takeHooks(), "");
    }
    EXPECT_EQ(activity->timeouts, 0);
}

TEST_F(Triggering, ReadyFileDescriptorIsAFullStep) {
    const int fd = eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
    auto* const io = new extras::FileDescriptorActivity(ORO_SCHED_OTHER, 0);
    ASSERT_TRUE(c.setActivity(io));
    ASSERT_TRUE(c.engine()->runFunction(&function));
    c.onUpdate = [&] {
        eventfd_t value = 0;
        c.note(io->isUpdated(fd) && eventfd_read(fd, &value) == 0 ? "input" : "no input");
    };
    io->watch(fd);
    ASSERT_TRUE(c.start());
    EXPECT_EQ(takeHooks(), "start");
    const auto inputs = [&] { return Attribute<unsigned>(c.getAttribute("IOCounter")).get(); };
    ASSERT_EQ(eventfd_write(fd, 1), 0);
    ASSERT_TRUE(eventually([&] { return c.updates >= 1; }));
    EXPECT_EQ(takeHooks(), "function input");
    ASSERT_TRUE(c.getActivity()->stop());
    EXPECT_EQ(inputs(), 1u);
    io->unwatch(fd);
    close(fd);
}

TEST_P(Triggering, MessagesAreExecutedInEveryStateButFatalError) {
    useActivity(GetParam());
    const auto served = [this] {
        OperationCaller<void()> op(c.getOperation("op"), internal::GlobalEngine::Instance());
        return op.send().collect() == SendSuccess;
    };
    EXPECT_TRUE(served()) << "Stopped";
    ASSERT_TRUE(c.cleanup());
    EXPECT_TRUE(served()) << "PreOperational";
    ASSERT_TRUE(c.configure() && c.start());
    EXPECT_TRUE(served()) << "Running";
    c.error();
    EXPECT_TRUE(served()) << "RunTimeError";
    c.exception();
    EXPECT_TRUE(served()) << "Exception";
    c.fatal();
    EXPECT_FALSE(served());
}

INSTANTIATE_TEST_SUITE_P(Period, Triggering, testing::Values(kNotPeriodic, kEndlessPeriod),
                         [](const auto& info) { return info.param == 0.0 ? "None" : "Endless"; });

}  // namespace
