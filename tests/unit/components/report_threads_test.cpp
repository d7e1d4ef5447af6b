// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A reporter in its own thread, while others write, change what is reported, and start and stop it.
#include "repeated.hpp"
#include "reporter_fixture.hpp"

#include <rtt/Activity.hpp>
#include <rtt/Attribute.hpp>
#include <rtt/OperationCaller.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <support/temp_dir.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <thread>

namespace {

using namespace components_test;

class ReportThreads : public Reporting {
protected:
    void inOwnThread(double period) {
        reporter->setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, period, nullptr, "Reporter"));
    }
    void forAWhile() { std::this_thread::sleep_for(std::chrono::milliseconds(200)); }
    static std::ptrdiff_t linesIn(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

    void changeWhatIsReported() {
        EXPECT_TRUE(reporter->reportPort("Machine", "speed"));
        EXPECT_TRUE(reporter->reportPort("Machine", "levels"));
        EXPECT_TRUE(reporter->reportData("Machine", "gain"));
        EXPECT_TRUE(reporter->unreportPort("Machine", "speed"));
        EXPECT_TRUE(reporter->unreportData("Machine", "gain"));
        EXPECT_TRUE(reporter->unreportComponent("Machine"));
    }
};

TEST_F(ReportThreads, WhatIsReportedChangesWhileAPeriodicReporterRuns) {
    inOwnThread(0.001);
    for (int round = 0; round < 3; ++round) {
        ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
        ASSERT_TRUE(reporter->reportPort("Machine", "levels"));
        ASSERT_TRUE(reporter->start());
        std::vector<double> levels;
        const Repeated writer([&] {
            machine.speed.write(1);
            levels.resize((levels.size() + 1) % 5);
            machine.levels.write(levels);
        });
        reporter->unreportComponent("Machine");
        const Repeated changer([this] { changeWhatIsReported(); });
        forAWhile();
        EXPECT_TRUE(reporter->stop());
    }
    EXPECT_GT(linesIn(text.str()), 10);
    EXPECT_EQ(0u, text.str().find(" TimeStamp Machine.speed Machine.levels[0]\n"));
}

TEST_F(ReportThreads, WhatIsReportedChangesWhileDataWakesTheReporter) {
    inOwnThread(0.0);
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    ASSERT_TRUE(reporter->start());
    {
        const Repeated writer([this] { machine.speed.write(1); });
        forAWhile();
        const Repeated changer([this] {
            EXPECT_TRUE(reporter->reportPort("Machine", "place"));
            EXPECT_TRUE(reporter->unreportPort("Machine", "place"));
        });
        forAWhile();
        EXPECT_TRUE(reporter->stop());
    }
    EXPECT_GT(linesIn(text.str()), 10);
}

TEST_F(ReportThreads, SnapshotsAndStopsMayComeAtAnyTime) {
    property<bool>("Snapshot") = true;
    inOwnThread(0.0);
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    RTT::OperationCaller<void()> snapshot(reporter->getOperation("snapshot"), RTT::internal::GlobalEngine::Instance());
    const Repeated writer([this] { machine.speed.write(1); });
    for (int round = 0; round < 20; ++round) {
        ASSERT_TRUE(reporter->start());
        RTT::SendHandle<void()> last;
        for (int i = 0; i < 20; ++i) last = snapshot.send();
        if (round % 2 == 0) {
            EXPECT_EQ(RTT::SendSuccess, last.collect());
        }
        EXPECT_TRUE(reporter->stop());
    }
    EXPECT_GE(linesIn(text.str()), 20 + 10 * 20);
}

}  // namespace
