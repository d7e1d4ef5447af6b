// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Deployment files with errors: the deployer runs on `input.xml` (or with the words in `args`) in the case's directory.
#include <support/child_process.hpp>
#include <support/golden.hpp>
#include <support/temp_dir.hpp>

#include <gtest/gtest.h>

#include <sstream>

namespace {

using namespace oroforge::test;

std::vector<std::string> argumentsOf(const std::filesystem::path& directory) {
    std::string words = "--check -s input.xml";
    if (std::filesystem::exists(directory / "args")) words = readFile(directory / "args");
    std::istringstream stream(words);
    std::vector<std::string> result = {"--no-consolelog"};
    for (std::string word; stream >> word;) result.push_back(word);
    return result;
}

/** What differs from machine to machine. */
std::string normalised(std::string text) {
    const std::string libraries = std::filesystem::canonical(DEPLOYER_LIB_PATH).string();
    return replaceAll(replaceAll(text, DEPLOYER_TEST_PATH, "<test path>"), libraries, "<lib path>");
}

class DeployGolden : public testing::TestWithParam<std::string> {};

TEST_P(DeployGolden, IsRefusedWithTheseMessages) {
    const std::filesystem::path directory = goldenDir("deploy", GetParam());
    const TempDir scratch;
    Command command;
    command.program = DEPLOYER_PROGRAM;
    command.arguments = argumentsOf(directory);
    command.directory = directory;
    command.environment = {{"RTT_COMPONENT_PATH", DEPLOYER_TEST_PATH},
                           {"ORO_LOGFILE", (scratch / "orocos.log").string()}};
    command.timeout = std::chrono::seconds(30);
    const Outcome outcome = run(command);
    EXPECT_EQ(255, outcome.status);
    EXPECT_FALSE(outcome.timedOut);
    expectGolden(directory / "expected/stderr.txt", normalised(outcome.err));
    // Whatever was created is gone again, the last first.
    expectGolden(directory / "expected/stdout.txt", normalised(outcome.out));
}

INSTANTIATE_TEST_SUITE_P(Golden, DeployGolden, testing::ValuesIn(goldenCases("deploy")), caseName);

}  // namespace
