// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Calls to components that nobody executes just now.
#include "logger_capture.hpp"
#include "os_test.hpp"

#include <rtt/Activity.hpp>
#include <rtt/OperationCaller.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/extras/Activities.hpp>
#include <rtt/internal/GlobalEngine.hpp>

#include <memory>
#include <thread>

using namespace RTT;
using oroforge::test::eventually;

namespace {

struct InactiveComponent : testing::TestWithParam<const char*> {
    InactiveComponent() {
        master.setActivity(new extras::SequentialActivity);
        EXPECT_TRUE(server.setActivity(make()));
        server.addOperation(
            "answer", [] { return 42; }, OwnThread);
    }
    ~InactiveComponent() override { server.getActivity()->stop(); }
    base::ActivityInterface* make() {
        const std::string kind = GetParam();
        if (kind == "sequential") return new extras::SequentialActivity;
        if (kind == "slave") return new extras::SlaveActivity(master.getActivity());
        if (kind == "periodic") return new extras::PeriodicActivity(ORO_SCHED_OTHER, 0, 0.002);
        if (kind == "descriptors") return new extras::FileDescriptorActivity(ORO_SCHED_OTHER, 0);
        return new Activity(ORO_SCHED_OTHER, 0, kind == "with_period" ? 0.002 : 0.0);
    }
    int warnings() const { return log.count("a call waits until the activity of component 'server' is started"); }
    oroforge::test::LoggerCapture log;
    TaskContext master{"master"}, server{"server"};
};

TEST_P(InactiveComponent, AnswersWhenItsActivityIsStartedAndACallSaysThatItWaits) {
    OperationCaller<int()> answer(server.getOperation("answer"), internal::GlobalEngine::Instance());
    EXPECT_EQ(answer(), 42);
    EXPECT_EQ(warnings(), 0);
    ASSERT_TRUE(eventually([&] { return server.getActivity()->stop(); }));
    std::atomic<int> answered{0};
    std::thread caller([&] { answered = answer(); });
    ASSERT_TRUE(eventually([&] { return server.engine()->hasWork(); }));
    EXPECT_TRUE(eventually([&] { return warnings() == 1; }));
    EXPECT_EQ(answered, 0);
    EXPECT_TRUE(server.activate());
    EXPECT_TRUE(eventually([&] { return answered == 42; }));
    caller.join();
    EXPECT_EQ(warnings(), 1) << log.text();
}

TEST_P(InactiveComponent, FreesWhoWaitsForItWhenItIsDestroyed) {
    auto other = std::make_unique<TaskContext>("other");
    ASSERT_TRUE(other->setActivity(make()));
    other->addOperation(
        "answer", [] { return 42; }, OwnThread);
    OperationCaller<int()> answer(other->getOperation("answer"), internal::GlobalEngine::Instance());
    ASSERT_TRUE(eventually([&] { return other->getActivity()->stop(); }));
    std::atomic<bool> refused{false};
    std::thread caller([&] {
        try {
            answer();
        } catch (const SendError&) {
            refused = true;
        }
    });
    ASSERT_TRUE(eventually([&] { return other->engine()->hasWork(); }));
    other.reset();
    caller.join();
    EXPECT_TRUE(refused);
}

INSTANTIATE_TEST_SUITE_P(Kinds, InactiveComponent,
                         testing::Values("sequential", "slave", "periodic", "descriptors", "with_period", "triggered"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
