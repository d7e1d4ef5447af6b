// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Scripts with errors: what a component says about `input.ops`, what the script did before, and what runScript returns. A file
// `args` with the word `info` has the lines of that level as well.
#include "robot.hpp"

#include <rtt/Logger.hpp>
#include <rtt/OperationCaller.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <support/golden.hpp>
#include <unit/flow/log_capture.hpp>

#include <filesystem>
#include <regex>

namespace {

using namespace scripting_corpus;
using namespace oroforge::test;

class ScriptGolden : public testing::TestWithParam<std::string> {
protected:
    ScriptGolden() {
        loadTypesAndScripting();
        EXPECT_TRUE(robot.loadService("scripting"));
        // Its thread is created now, not while the script runs, which would be told.
        RTT::internal::GlobalEngine::Instance();
    }

    std::string outcomeOf(const std::filesystem::path& script) {
        RTT::Logger::Instance()->setLogLevel(std::filesystem::exists("args") ? RTT::Logger::Info
                                                                             : RTT::Logger::Warning);
        const flow_test::LogCapture log;
        RTT::OperationCaller<bool(const std::string&)> run(robot.provides("scripting")->getOperation("runScript"));
        EXPECT_TRUE(run.ready());
        const bool result = run.ready() && run(script.string());
        std::string outcome = std::regex_replace(log.text(), std::regex("(^|\n)[0-9.]+ \\["), "$1[");
        for (const std::string& note : robot.notes()) outcome += "note: " + note + "\n";
        return outcome + "runScript returns " + (result ? "true\n" : "false\n");
    }

    Robot robot;
};

TEST_P(ScriptGolden, GivesTheseMessages) {
    const std::filesystem::path directory = goldenDir("script", GetParam());
    // Messages name the file as it was given.
    std::filesystem::current_path(directory);
    expectGolden(directory / "expected/log.txt", outcomeOf("input.ops"));
}

INSTANTIATE_TEST_SUITE_P(Golden, ScriptGolden, testing::ValuesIn(goldenCases("script")), caseName);

}  // namespace
