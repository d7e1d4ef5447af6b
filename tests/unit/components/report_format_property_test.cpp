// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The property Format: csv, and names that are no format.
#include "reporter_fixture.hpp"

#include <ocl/FileReporting.hpp>
#include <rtt/types/TemplateTypeInfo.hpp>
#include <support/temp_dir.hpp>

#include <cmath>
#include <locale>

namespace {

using namespace components_test;

class ReportFormat : public Reporting {};

struct Opaque {
    int hidden = 0;
};

TEST_F(ReportFormat, CsvHasAFieldPerColumnAndAHeaderPerShape) {
    property<std::string>("Format") = "csv";
    machine.speed.write(1.0 / 3);
    machine.place.write({std::nan(""), -HUGE_VAL});
    for (const char* port : {"speed", "levels", "place"}) ASSERT_TRUE(reporter->reportPort("Machine", port));
    ASSERT_TRUE(reporter->reportData("Machine", "label"));
    ASSERT_TRUE(reporter->start());
    machine.label = "say \"so\",\nplease";
    machine.levels.write({1, 2});
    cycle();
    machine.label = "";
    machine.levels.write({3});
    cycle();
    EXPECT_EQ(
        "TimeStamp,Machine.speed,Machine.levels[0],Machine.place.x,Machine.place.y,Machine.label\n"
        "0,0.3333333333333333,0,nan,-inf,blue\n"
        "TimeStamp,Machine.speed,Machine.levels[0],Machine.place.x,Machine.place.y,Machine.label,Machine.levels.0,"
        "Machine.levels.1\n"
        "0.5,0.3333333333333333,,nan,-inf,\"say \"\"so\"\",\nplease\",1,2\n"
        "1,0.3333333333333333,,nan,-inf,\"\",3,\n",
        report());
}

TEST_F(ReportFormat, CsvHasEmptyFieldsForWhatIsNotNew) {
    property<std::string>("Format") = "csv";
    property<bool>("ReportOnlyNewData") = true;
    machine.speed.write(1);
    machine.levels.write({1, 2});
    for (const char* port : {"levels", "speed"}) ASSERT_TRUE(reporter->reportPort("Machine", port));
    ASSERT_TRUE(reporter->start());
    machine.speed.write(2);
    cycle();
    machine.levels.write({3, 4});
    cycle();
    EXPECT_EQ("TimeStamp,Machine.levels.0,Machine.levels.1,Machine.speed\n0,1,2,1\n0.5,,,2\n1,3,4,\n", report());
}

TEST_F(ReportFormat, NamesWithSeparatorsAreOneField) {
    machine.limits.ownProperty(new RTT::Property<int>("too low, \"or\" not", "", 1));
    ASSERT_TRUE(reporter->reportData("Machine", "limits"));
    ASSERT_TRUE(reporter->start());
    ASSERT_TRUE(reporter->stop());
    property<std::string>("Format") = "csv";
    ASSERT_TRUE(reporter->start());
    EXPECT_EQ(
        " TimeStamp Machine.limits.too\\x20low,\\x20\\x22or\\x22\\x20not\n 0  1 \n"
        "TimeStamp,\"Machine.limits.too low, \"\"or\"\" not\"\n0,1\n",
        report());
}

TEST_F(ReportFormat, TextsKeepToTheirColumn) {
    machine.label = "# two \"words\"\r\n";
    for (const char* name : {"label", "gain"}) ASSERT_TRUE(reporter->reportData("Machine", name));
    ASSERT_TRUE(reporter->start());
    EXPECT_EQ(" TimeStamp Machine.label Machine.gain\n 0 \\x23\\x20two\\x20\\x22words\\x22\\x0d\\n 1.5 \n", report());
}

TEST_F(ReportFormat, AnotherNameFailsConfigureAndStart) {
    const oroforge::test::TempDir folder;
    OCL::FileReporting files("Files");
    RTT::Property<std::string>(files.getProperty("ReportFile")).set(folder / "r.dat");
    files.addPeer(&machine);
    for (OCL::ReportingComponent* each :
         {static_cast<OCL::ReportingComponent*>(reporter.get()), static_cast<OCL::ReportingComponent*>(&files)}) {
        const LogText log;
        ASSERT_TRUE(each->reportPort("Machine", "speed"));
        for (const char* name : {"CSV", "", "xml"}) {
            RTT::Property<std::string>(each->getProperty("Format")).set(name);
            EXPECT_FALSE(each->configure());
            EXPECT_FALSE(each->start());
        }
        EXPECT_THAT(log(), HasSubstr("the property Format of '" + each->getName() +
                                     "' is 'xml'; it must be 'columns' or 'csv'"));
        RTT::Property<std::string>(each->getProperty("Format")).set("csv");
        EXPECT_TRUE(each->configure());
        EXPECT_TRUE(each->start());
        each->stop();
    }
    EXPECT_EQ(0u, oroforge::test::readFile(folder / "r.dat").find("TimeStamp,Machine.speed\n"));
}

TEST_F(ReportFormat, ATypeWithoutMembersAndTextIsReportedOnce) {
    RTT::types::Types()->addType(new RTT::types::TemplateTypeInfo<Opaque, false>("Opaque"));
    RTT::OutputPort<Opaque> one("one"), other("other");
    machine.ports()->addPort(one);
    machine.ports()->addPort(other);
    for (const char* port : {"one", "other", "speed"}) ASSERT_TRUE(reporter->reportPort("Machine", port));
    const LogText log;
    ASSERT_TRUE(reporter->start());
    cycle();
    EXPECT_THAT(report(), HasSubstr("\n 0.5 (Opaque) (Opaque) 0 \n"));
    EXPECT_THAT(log(), HasSubstr("the report of 'Reporter' has no values of type 'Opaque', only its name: a typekit"));
    for (const char* port : {"one", "other"}) machine.ports()->removePort(port);
}

/** Writes numbers as some countries do. */
class Commas : public std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST_F(ReportFormat, LocalesHaveNoInfluence) {
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Commas));
    machine.speed.write(12345.5);
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    for (const char* format : {"columns", "csv"}) {
        property<std::string>("Format") = format;
        ASSERT_TRUE(reporter->start());
        ASSERT_TRUE(reporter->stop());
    }
    std::locale::global(before);
    EXPECT_EQ(" TimeStamp Machine.speed\n 0 12345.5 \nTimeStamp,Machine.speed\n0,12345.5\n", text.str());
}

}  // namespace
