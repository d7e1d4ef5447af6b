// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a report looks like: header, rows, columns of values of all kinds.
#include "reporter_fixture.hpp"

#include <cmath>
#include <iterator>
#include <sstream>

namespace {

using namespace components_test;

class ReportColumns : public Reporting {
protected:
    /** A header, and rows of as many words. */
    void expectRowsLikeTheHeader(std::size_t lines) {
        std::istringstream rows(report());
        std::vector<std::size_t> columns;
        for (std::string row; std::getline(rows, row);) {
            std::istringstream words(row);
            columns.push_back(std::distance(std::istream_iterator<std::string>(words), {}));
        }
        EXPECT_EQ(std::vector<std::size_t>(lines, columns.at(0)), columns) << text.str();
    }
};

TEST_F(ReportColumns, HeaderThenOneRowPerCycle) {
    machine.speed.write(1.0 / 3);
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    ASSERT_TRUE(reporter->start());
    machine.speed.write(2e9);
    cycle();
    cycle(1000.25);
    EXPECT_EQ(
        " TimeStamp Machine.speed\n"
        " 0 0.333333 \n"
        " 0.5 2e+09 \n"
        " 1000.75 2e+09 \n",
        report());
}

TEST_F(ReportColumns, DigitsAreThoseOfAStreamUnlessPrecisionSaysOtherwise) {
    property<int>("Precision") = 12;
    machine.speed.write(1.0 / 3);
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    ASSERT_TRUE(reporter->start());
    EXPECT_THAT(report(), HasSubstr(" 0 0.333333333333 \n"));
}

TEST_F(ReportColumns, StructsGetAColumnPerMemberAndABlankOfTheirOwn) {
    machine.place.write({1, 2});
    ASSERT_TRUE(reporter->reportPort("Machine", "place"));
    ASSERT_TRUE(reporter->start());
    EXPECT_EQ(
        " TimeStamp Machine.place.x Machine.place.y\n"
        " 0  1 2 \n",
        report());
}

TEST_F(ReportColumns, MembersOfAllKindsHaveTheirColumns) {
    sample::Tank tank;
    tank.id = -7;
    tank.label = "left";
    tank.position = {1, 2};
    tank.levels = {0.5, 0.25};
    tank.path = {{3, 4}};
    tank.weights[2] = 9;
    tank.pair = {{5, 6}};
    tank.mode = sample::Mode::Filling;
    tank.small = 200;
    tank.flags = {true, false};
    machine.tank.write(tank);
    ASSERT_TRUE(reporter->reportPort("Machine", "tank"));
    ASSERT_TRUE(reporter->start());
    EXPECT_EQ(
        " TimeStamp Machine.tank.id Machine.tank.label Machine.tank.position.x Machine.tank.position.y"
        " Machine.tank.levels.0 Machine.tank.levels.1 Machine.tank.path.0.x Machine.tank.path.0.y"
        " Machine.tank.weights.0 Machine.tank.weights.1 Machine.tank.weights.2 Machine.tank.pair.0 Machine.tank.pair.1"
        " Machine.tank.mode Machine.tank.small Machine.tank.flags.0 Machine.tank.flags.1\n"
        " 0  -7 left  1 2  0.5 0.25   3 4  0 0 9  5 6 Filling 200  1 0 \n",
        report());
}

TEST_F(ReportColumns, EnumeratorsAreNamed) {
    machine.mode.write(sample::Mode::Draining);
    ASSERT_TRUE(reporter->reportPort("Machine", "mode"));
    ASSERT_TRUE(reporter->start());
    machine.mode.write(sample::Mode::Idle);
    cycle();
    EXPECT_EQ(" TimeStamp Machine.mode\n 0 Draining \n 0.5 Idle \n", report());
}

TEST_F(ReportColumns, WithoutDecomposeAValueIsOneColumn) {
    property<bool>("Decompose") = false;
    machine.place.write({1, 2});
    machine.speed.write(3);
    ASSERT_TRUE(reporter->reportPort("Machine", "place"));
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    ASSERT_TRUE(reporter->start());
    EXPECT_EQ(" TimeStamp Machine.place Machine.speed\n 0 {x\\x20=\\x201,\\x20y\\x20=\\x202} 3 \n", report());
}

TEST_F(ReportColumns, ComplexDecomposeTakesValuesApartAsPropertyFilesDo) {
    property<bool>("ComplexDecompose") = true;
    machine.place.write({1, 2});
    machine.levels.write({7, 8});
    machine.speed.write(3);
    for (const char* port : {"place", "levels", "speed"}) ASSERT_TRUE(reporter->reportPort("Machine", port));
    ASSERT_TRUE(reporter->start());
    machine.place.write({3, 4});
    machine.levels.write({9});
    cycle();
    EXPECT_EQ(
        " TimeStamp Machine.place.x Machine.place.y Machine.levels.Element0 Machine.levels.Element1 Machine.speed\n"
        " 0  1 2  7 8 3 \n"
        " 0.5 3 4 9 nan 3 \n",
        report());
}

TEST_F(ReportColumns, ElementsThatComeLaterHaveTheirColumnsBehindAllOthers) {
    const LogText log;
    machine.speed.write(5);
    ASSERT_TRUE(reporter->reportPort("Machine", "levels"));
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    ASSERT_TRUE(reporter->start());
    for (const std::vector<double>& levels : {std::vector<double>{1, 2}, {3}, {}, {4, 5, 6}, {7}}) {
        machine.levels.write(levels);
        cycle();
    }
    EXPECT_EQ(
        " TimeStamp Machine.levels[0] Machine.speed\n"
        " 0  0 5 \n"
        " TimeStamp Machine.levels[0] Machine.speed Machine.levels.0 Machine.levels.1\n"
        " 0.5 nan 5 1 2 \n"
        " 1 nan 5 3 nan \n"
        " 1.5 0 5 nan nan \n"
        " TimeStamp Machine.levels[0] Machine.speed Machine.levels.0 Machine.levels.1 Machine.levels.2\n"
        " 2 nan 5 4 5 6 \n"
        " 2.5 nan 5 7 nan nan \n",
        report());
    const std::string said = log();
    const std::size_t first = said.find("the report of 'Reporter' has more columns since 'Machine.levels.0'");
    EXPECT_NE(std::string::npos, first) << said;
    EXPECT_EQ(std::string::npos, said.find("more columns", first + 60)) << said;
}

TEST_F(ReportColumns, AnnouncedSizesHaveTheirColumnsBeforeTheFirstSample) {
    const LogText log;
    machine.levels.setDataSample({0, 0});
    ASSERT_TRUE(reporter->reportPort("Machine", "levels"));
    ASSERT_TRUE(reporter->start());
    machine.levels.write({1, 2});
    cycle();
    EXPECT_EQ(" TimeStamp Machine.levels.0 Machine.levels.1\n 0  0 0 \n 0.5  1 2 \n", report());
    EXPECT_EQ("", log());
}

TEST_F(ReportColumns, HeaderIsNotRepeatedIfNotWanted) {
    property<bool>("RepeatHeader") = false;
    machine.levels.write({1});
    ASSERT_TRUE(reporter->reportPort("Machine", "levels"));
    ASSERT_TRUE(reporter->start());
    machine.levels.write({2, 3});
    cycle();
    EXPECT_EQ(
        " TimeStamp Machine.levels.0\n"
        " 0  1 \n"
        " 0.5  2 3 \n",
        report());
}

TEST_F(ReportColumns, RowsThatBecomeMuchLongerFindRoom) {
    constexpr int kElements = 100000;  // a small image
    ASSERT_TRUE(reporter->reportPort("Machine", "levels"));
    ASSERT_TRUE(reporter->start());
    machine.levels.write(std::vector<double>(kElements, 7));
    for (int i = 0; i < 3; ++i) cycle();
    machine.levels.write({8});
    cycle();
    const std::string first = " TimeStamp Machine.levels[0]";
    std::string more = first, image = " nan ", last = " 2 nan 8 ";
    for (int i = 0; i < kElements; ++i) {
        more += " Machine.levels." + std::to_string(i);
        image += "7 ";
        if (i != 0) last += "nan ";
    }
    const std::string rows = report();
    EXPECT_TRUE(rows ==
                first + "\n 0  0 \n" + more + "\n 0.5" + image + "\n 1" + image + "\n 1.5" + image + "\n" + last + "\n")
        << rows.size() << " bytes: " << rows.substr(0, 100);
}

TEST_F(ReportColumns, NumbersThatAreNoneAreWrittenAsStreamsDo) {
    machine.levels.write({std::nan(""), HUGE_VAL, -HUGE_VAL, -0.0});
    ASSERT_TRUE(reporter->reportPort("Machine", "levels"));
    property<bool>("WriteHeader") = false;
    ASSERT_TRUE(reporter->start());
    EXPECT_EQ(" 0  nan inf -inf -0 \n", report());
}

TEST_F(ReportColumns, AnEmptySequenceKeepsTheColumnsBehindItInTheirPlaces) {
    machine.limits.ownProperty(new RTT::Property<RTT::PropertyBag>("none"));
    machine.speed.write(5);
    ASSERT_TRUE(reporter->reportPort("Machine", "levels"));
    ASSERT_TRUE(reporter->reportPort("Machine", "tank"));
    ASSERT_TRUE(reporter->reportData("Machine", "limits"));
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    sample::Tank tank;
    tank.label = "left";
    machine.tank.write(tank);
    ASSERT_TRUE(reporter->start());
    cycle();
    expectRowsLikeTheHeader(3);
}

TEST_F(ReportColumns, WhatHasNothingToShowKeepsTheColumnsBehindItInTheirPlaces) {
    machine.label = "";
    machine.tank.write(sample::Tank());
    ASSERT_TRUE(reporter->reportPort("Machine", "tank"));  // an empty string and empty sequences in a struct
    for (const char* name : {"label", "limits", "gain"}) ASSERT_TRUE(reporter->reportData("Machine", name));
    property<bool>("ComplexDecompose") = true;
    ASSERT_TRUE(reporter->start());
    cycle();
    expectRowsLikeTheHeader(3);
}

TEST_F(ReportColumns, SequencesOfStructsGrowAndShrink) {
    ASSERT_TRUE(reporter->reportPort("Machine", "tank"));
    sample::Tank tank;
    machine.tank.write(tank);
    ASSERT_TRUE(reporter->start());
    tank.path = {{1, 2}, {3, 4}};
    machine.tank.write(tank);
    cycle();
    const std::string rows = report();
    EXPECT_THAT(rows, HasSubstr(" Machine.tank.path[0] "));
    EXPECT_THAT(rows, HasSubstr(" Machine.tank.path.0.x Machine.tank.path.0.y Machine.tank.path.1.x "
                                "Machine.tank.path.1.y\n 0.5 "));
    EXPECT_THAT(rows, HasSubstr(" 1 2 3 4 \n"));
}

TEST_F(ReportColumns, PropertiesAndAttributesAreReportedAsTheyAre) {
    machine.limits.ownProperty(new RTT::Property<int>("low", "", 1));
    machine.limits.ownProperty(new RTT::Property<int>("", "", 2));
    for (const char* name : {"gain", "label", "limits"}) ASSERT_TRUE(reporter->reportData("Machine", name));
    ASSERT_TRUE(reporter->start());
    machine.gain = 2;
    machine.label = "two\nlines";
    cycle();
    EXPECT_EQ(
        " TimeStamp Machine.gain Machine.label Machine.limits.low Machine.limits.2\n"
        " 0 1.5 blue  1 2 \n"
        " 0.5 2 two\\nlines  1 2 \n",
        report());
}

TEST_F(ReportColumns, PortsOfServicesKeepTheirPath) {
    ASSERT_TRUE(reporter->reportPort("Machine", "motor.current"));
    ASSERT_TRUE(reporter->start());
    machine.current.write(0.1f);
    cycle();
    EXPECT_EQ(" TimeStamp Machine.motor.current\n 0 0 \n 0.5 0.1 \n", report());
    EXPECT_NE(nullptr, reporter->getPort("Machine_motor.current"));
}

TEST_F(ReportColumns, WriteHeaderOffLeavesRowsOnly) {
    property<bool>("WriteHeader") = false;
    ASSERT_TRUE(reporter->reportData("Machine", "gain"));
    ASSERT_TRUE(reporter->start());
    EXPECT_EQ(" 0 1.5 \n", report());
}

TEST_F(ReportColumns, SynchronizedTimeCountsFromTheBeginningOfTheLog) {
    property<bool>("Synchronize") = true;
    ASSERT_TRUE(reporter->reportData("Machine", "gain"));
    const double before = RTT::os::TimeService::Instance()->secondsSince(RTT::Logger::Instance()->getReferenceTime());
    ASSERT_TRUE(reporter->start());
    std::ostringstream expected;
    expected << " " << before << " 1.5 \n";
    EXPECT_THAT(report(), HasSubstr(expected.str()));
}

}  // namespace
