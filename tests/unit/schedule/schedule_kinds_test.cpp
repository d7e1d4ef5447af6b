// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What becomes of each kind of activity in a schedule.
#include "recorded_times.hpp"

#include <flow/log_capture.hpp>
#include <rtt/Activity.hpp>
#include <rtt/Logger.hpp>
#include <rtt/extras/FileDescriptorActivity.hpp>
#include <rtt/extras/PeriodicActivity.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/internal/engine/deferred_activity.hpp>

#include <gmock/gmock.h>

#include <thread>

namespace {

using namespace schedule_test;
using OCL::schedule::Schedule;
using testing::ElementsAre;
using testing::HasSubstr;

class ScheduleKindsTest : public testing::Test {
protected:
    void run(long ms) {
        times_.until(ms);
        EXPECT_TRUE(schedule_.run(times_, never).isComplete);
    }
    Events events_;
    Times times_;
    Schedule schedule_{kStart};
};

TEST_F(ScheduleKindsTest, AnActivityThatTheConstructorSets) {
    struct Own : Noting {
        explicit Own(Events& events) : Noting("own", events) {
            activity = new RTT::Activity(ORO_SCHED_OTHER, 0, 0.02);
            setActivity(activity);
        }
        RTT::Activity* activity;  // which it may use later
    } own(events_);
    EXPECT_EQ(own.activity->getPeriod(), 0.02);
    EXPECT_NE(own.getActivity(), own.activity);
    EXPECT_EQ(own.getPeriod(), 0.02);
    ASSERT_TRUE(own.start());
    run(40);
    EXPECT_THAT(events_, ElementsAre("own@20", "own@40"));
}

TEST_F(ScheduleKindsTest, OneThatFollowsLater) {
    const RTT::internal::ActivityFollows follows("A");
    Noting a("A", events_);
    ASSERT_TRUE(a.setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, 0.01)));
    ASSERT_TRUE(a.start());
    run(10);
    EXPECT_THAT(events_, ElementsAre("A@10"));
}

TEST_F(ScheduleKindsTest, APeriodicActivityExecutesMessagesAtItsPeriod) {
    Noting a("A", events_);
    ASSERT_TRUE(a.setActivity(new RTT::extras::PeriodicActivity(ORO_SCHED_OTHER, 0, 0.01)));
    ASSERT_TRUE(a.start());
    times_.at(5, [&] { EXPECT_FALSE(a.getActivity()->trigger()); });
    run(20);
    EXPECT_THAT(events_, ElementsAre("A@10", "A@20"));
}

TEST_F(ScheduleKindsTest, ASlaveExecutesInItsMaster) {
    Noting master("master", events_), slave("slave", events_);
    ASSERT_TRUE(master.setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, 0.01)));
    ASSERT_TRUE(slave.setActivity(new RTT::extras::SlaveActivity(master.getActivity())));
    master.update = [&] { EXPECT_TRUE(slave.getActivity()->execute()); };
    ASSERT_TRUE(master.start());
    ASSERT_TRUE(slave.start());
    run(20);
    EXPECT_THAT(events_, ElementsAre("master@10", "slave@10", "master@20", "slave@20"));
}

TEST_F(ScheduleKindsTest, ASequentialOneExecutesAtOnce) {
    Noting caller("caller", events_), sequential("sequential", events_);
    ASSERT_TRUE(sequential.setActivity(new RTT::extras::SequentialActivity));
    caller.update = [&] {
        sequential.getActivity()->trigger();
        events_.push_back("returned");
    };
    ASSERT_TRUE(caller.start());
    ASSERT_TRUE(sequential.start());
    times_.at(1, [&] { caller.trigger(); });
    run(1);
    EXPECT_THAT(events_, ElementsAre("caller@1", "sequential@1", "returned"));
}

TEST_F(ScheduleKindsTest, FileDescriptorsAreNeverReadyButTimeoutsCome) {
    flow_test::LogCapture log;
    Noting a("A", events_);
    ASSERT_TRUE(a.setActivity(new RTT::extras::FileDescriptorActivity(ORO_SCHED_OTHER, 0)));
    EXPECT_THAT(log.text(), HasSubstr("RPL004"));
    auto* const io = dynamic_cast<RTT::extras::FileDescriptorActivityInterface*>(a.getActivity());
    ASSERT_TRUE(io);
    io->watch(0);
    EXPECT_TRUE(io->isWatched(0));
    io->setTimeout(10);
    bool timedOut = false;
    a.update = [&] {
        timedOut = io->hasTimeout();
        EXPECT_FALSE(io->isUpdated(0));
    };
    ASSERT_TRUE(a.start());
    run(20);
    EXPECT_THAT(events_, ElementsAre("A@10", "A@20"));
    EXPECT_TRUE(timedOut);
}

TEST_F(ScheduleKindsTest, AClassOfItsOwnIsReportedAndKeepsItsThread) {
    struct Mine : RTT::Activity {
        Mine() : RTT::Activity(ORO_SCHED_OTHER, 0, 0.0) {}
    };
    flow_test::LogCapture log;
    Noting a("A", events_);
    auto* const mine = new Mine;
    ASSERT_TRUE(a.setActivity(mine));
    EXPECT_EQ(a.getActivity(), mine);
    EXPECT_THAT(log.text(), HasSubstr("RPL003"));
    EXPECT_THAT(log.text(), HasSubstr("'A'"));
}

TEST(AfterAScheduleTest, TimePassesAndComponentsHaveThreads) {
    Events events;
    { const Schedule schedule(kStart); }
    EXPECT_TRUE(RTT::os::TimeService::Instance()->systemClockEnabled());
    Noting a("A", events);
    EXPECT_TRUE(dynamic_cast<RTT::Activity*>(a.getActivity()));
}

}  // namespace
