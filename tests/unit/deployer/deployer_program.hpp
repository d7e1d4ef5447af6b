// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_DEPLOYER_PROGRAM_HPP
#define OROFORGE_TESTS_DEPLOYER_PROGRAM_HPP

#include <support/child_process.hpp>
#include <support/temp_dir.hpp>

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <string>
#include <vector>

namespace deployer_test {

/** The deployer in a directory of its own, with the components of the tests. */
class DeployerInDirectory : public testing::Test {
protected:
    oroforge::test::Command command(const std::vector<std::string>& arguments) const {
        oroforge::test::Command result;
        result.program = DEPLOYER_PROGRAM;
        result.arguments = arguments;
        result.directory = directory_.path();
        result.environment = {
            {"RTT_COMPONENT_PATH", DEPLOYER_TEST_PATH}, {"ORO_LOGFILE", "orocos.log"}, {"ORO_LOGLEVEL", "4"}};
        result.timeout = std::chrono::seconds(30);
        return result;
    }

    /** One that runs until it is ended: its console waits for input. */
    oroforge::test::Command lasting(const std::vector<std::string>& arguments) const {
        oroforge::test::Command result = command(arguments);
        result.inputStaysOpen = true;
        return result;
    }

    /** Runs with these words until it says so, ends it with a signal, returns what it said. */
    oroforge::test::Outcome runUntil(const std::string& output, const std::vector<std::string>& words, int signal) {
        oroforge::test::ChildProcess deployer(lasting(words));
        EXPECT_TRUE(deployer.waitForOutput(output, std::chrono::seconds(20)));
        deployer.send(signal);
        return deployer.finish();
    }

    oroforge::test::TempDir directory_;
};

}  // namespace deployer_test

#endif
