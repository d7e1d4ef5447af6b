// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What is said of a file does not change where the log goes.
#include "deployer_program.hpp"

#include <gmock/gmock.h>

namespace {

using namespace oroforge::test;
using testing::HasSubstr;
using testing::Not;

class Report : public deployer_test::DeployerInDirectory {
protected:
    Report() {
        directory_.write("warned.xml",
                         "<properties><struct name='unused' type='ConnPolicy'>"
                         "<simple name='type' type='short'><value>0</value></simple></struct>"
                         "<simple name='Path' type='string'><value>.</value></simple></properties>");
        directory_.write("fails.ops", "var int parts = 0\nvar int each = 100 / parts\n");
    }
};

TEST_F(Report, TheLogGoesOnAfterAWarning) {
    const Outcome warned = run(command({"-s", "warned.xml", "-s", "fails.ops"}));
    EXPECT_EQ(255, warned.status);
    EXPECT_THAT(warned.err, HasSubstr("warned.xml:1:27: warning: [DEP018]"));
    EXPECT_THAT(warned.err, HasSubstr("fails.ops:2:1: error: [OPS400] division by zero"));
}

TEST_F(Report, TheConsoleLogStaysOffWhereItIsNotWanted) {
    const Outcome outcome = run(command({"--no-consolelog", "-s", "warned.xml", "-s", "fails.ops"}));
    EXPECT_EQ(255, outcome.status);
    EXPECT_THAT(outcome.err, HasSubstr("warned.xml:1:27: warning: [DEP018]"));
    EXPECT_THAT(outcome.err, Not(HasSubstr("OPS400")));
    EXPECT_THAT(readFile(directory_ / "orocos.log"), HasSubstr("fails.ops:2:1: error: [OPS400] division by zero"));
}

TEST_F(Report, WhatIsPrintedStandsInTheLogFileAsWell) {
    const Outcome outcome = run(command({"-s", "warned.xml"}));
    EXPECT_EQ(outcome.err.find("DEP018"), outcome.err.rfind("DEP018")) << outcome.err;
    EXPECT_THAT(readFile(directory_ / "orocos.log"), HasSubstr("warning: [DEP018]"));
}

}  // namespace
