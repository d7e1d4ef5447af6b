// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// When rows are written, and what is left out of them.
#include "reporter_fixture.hpp"

namespace {

using namespace components_test;

class ReportPolicy : public Reporting {};

TEST_F(ReportPolicy, WithoutPeriodEachSampleGivesARow) {
    reportOnData();
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    ASSERT_TRUE(reporter->start());
    machine.speed.write(1);
    machine.speed.write(2);
    EXPECT_EQ(" TimeStamp Machine.speed\n 0 1 \n 0 2 \n", report());
}

TEST_F(ReportPolicy, AllBufferedSamplesAreWrittenAtOnce) {
    property<RTT::ConnPolicy>("ReportPolicy") = RTT::ConnPolicy::buffer(10);
    reporter->setActivity(new RTT::extras::SlaveActivity());
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    ASSERT_TRUE(reporter->start());
    for (int i = 1; i <= 3; ++i) machine.speed.write(i);
    cycle(0);
    cycle(0);
    EXPECT_EQ(" TimeStamp Machine.speed\n 0 1 \n 0 2 \n 0 3 \n", report());
}

TEST_F(ReportPolicy, WhatCameBeforeTheStopIsWritten) {
    property<RTT::ConnPolicy>("ReportPolicy") = RTT::ConnPolicy::buffer(10);
    reporter->setActivity(new RTT::extras::SlaveActivity());
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    ASSERT_TRUE(reporter->start());
    for (int i = 1; i <= 3; ++i) machine.speed.write(i);
    EXPECT_EQ(" TimeStamp Machine.speed\n 0 1 \n 0 2 \n 0 3 \n", report());
}

TEST_F(ReportPolicy, SamplesFromBeforeTheStartGiveNoRow) {
    machine.speed.write(1);
    reportOnData();
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    ASSERT_TRUE(reporter->start());
    reporter->trigger();
    EXPECT_EQ(" TimeStamp Machine.speed\n", report());
}

TEST_F(ReportPolicy, TheNextReportBeginsWithTheLastSampleOfThisOne) {
    machine.speed.setDataSample(0.5);
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    machine.speed.write(1);
    ASSERT_TRUE(reporter->start());
    EXPECT_EQ(" TimeStamp Machine.speed\n 0 1 \n", report());
    text.str("");
    ASSERT_TRUE(reporter->start());
    EXPECT_EQ(" TimeStamp Machine.speed\n 0 1 \n", report());
}

TEST_F(ReportPolicy, InSnapshotModeOnlySnapshotWrites) {
    property<bool>("Snapshot") = true;
    reportOnData();
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    ASSERT_TRUE(reporter->start());
    machine.speed.write(1);
    machine.speed.write(2);
    reporter->snapshot();
    reporter->trigger();
    reporter->snapshot();
    EXPECT_EQ(" TimeStamp Machine.speed\n 0 2 \n 0 2 \n", report());
}

TEST_F(ReportPolicy, PeriodicReportersIgnoreSnapshotsAndData) {
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    ASSERT_TRUE(reporter->start());
    reporter->snapshot();
    machine.speed.write(1);
    EXPECT_FALSE(reporter->ports()->getPortType<RTT::InputPort<double>>("Machine_speed")->signalsInterface());
    EXPECT_EQ(" TimeStamp Machine.speed\n 0 0 \n", report());
}

TEST_F(ReportPolicy, SnapshotOfAReporterThatDoesNotRunWritesNothing) {
    reportOnData();
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    reporter->snapshot();
    ASSERT_TRUE(reporter->start());
    ASSERT_TRUE(reporter->stop());
    reporter->snapshot();
    EXPECT_EQ(" TimeStamp Machine.speed\n", text.str());
}

TEST_F(ReportPolicy, OnlyNewDataLeavesOutWhatIsAsBefore) {
    property<bool>("ReportOnlyNewData") = true;
    machine.speed.write(1);
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    ASSERT_TRUE(reporter->reportPort("Machine", "place"));
    ASSERT_TRUE(reporter->reportData("Machine", "gain"));
    ASSERT_TRUE(reporter->start());
    machine.place.write({3, 4});
    cycle();
    machine.gain = 7;
    cycle();
    cycle();
    machine.speed.write(1);  // the same value, but a new sample
    cycle();
    EXPECT_EQ(
        " TimeStamp Machine.speed Machine.place.x Machine.place.y Machine.gain\n"
        " 0 1  0 0 1.5 \n"
        " 0.5 nan 3 4 nan \n"
        " 1 nan nan nan 7 \n"
        " 1.5 nan nan nan nan \n"
        " 2 1 nan nan nan \n",
        report());
}

TEST_F(ReportPolicy, OnlyNewDataOfAReporterThatDataWakes) {
    property<bool>("ReportOnlyNewData") = true;
    machine.speed.write(1);
    machine.place.write({1, 1});
    reportOnData();
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    ASSERT_TRUE(reporter->reportPort("Machine", "place"));
    ASSERT_TRUE(reporter->start());
    machine.place.write({3, 4});
    machine.speed.write(5);
    EXPECT_EQ(" TimeStamp Machine.speed Machine.place.x Machine.place.y\n 0 nan 3 4 \n 0 5 nan nan \n", report());
}

TEST_F(ReportPolicy, EachStartBeginsANewReport) {
    ASSERT_TRUE(reporter->reportData("Machine", "gain"));
    ASSERT_TRUE(reporter->start());
    ASSERT_TRUE(reporter->stop());
    RTT::os::TimeService::Instance()->secondsChange(5);
    ASSERT_TRUE(reporter->start());
    EXPECT_EQ(" TimeStamp Machine.gain\n 0 1.5 \n TimeStamp Machine.gain\n 0 1.5 \n", report());
}

TEST_F(ReportPolicy, AReporterMayBeDestroyedWhileItRuns) {
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    ASSERT_TRUE(reporter->start());
    reporter.reset();
    EXPECT_EQ(" TimeStamp Machine.speed\n 0 0 \n", text.str());
    EXPECT_FALSE(machine.speed.connected());
}

TEST_F(ReportPolicy, APeerMayGoWhileItIsReported) {
    auto other = std::make_unique<RTT::TaskContext>("Other");
    RTT::OutputPort<int> count("count");
    other->addPort(count);
    reporter->addPeer(other.get());
    ASSERT_TRUE(reporter->reportPort("Other", "count"));
    ASSERT_TRUE(reporter->start());
    count.write(4);
    cycle();
    other.reset();
    cycle();
    EXPECT_EQ(" TimeStamp Other.count\n 0 0 \n 0.5 4 \n 1 4 \n", report());
}

}  // namespace
