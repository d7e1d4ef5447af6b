// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_CHECKED_SCRIPT_HPP
#define OROFORGE_TESTS_CHECKED_SCRIPT_HPP

#include "deployer_program.hpp"

#include <string>
#include <vector>

namespace deployer_test {

const std::string kImport = "import(\"deploytest\")\n";
const std::string kOne = kImport + "loadComponent(\"one\", \"deploytest::Consumer\")\n";

/** Runs and checks scripts. */
class CheckedScript : public DeployerInDirectory {
protected:
    oroforge::test::Outcome outcome(const std::vector<std::string>& options, const std::string& text) {
        directory_.write("app.ops", text);
        std::vector<std::string> words = options;
        words.insert(words.end(), {"-s", "app.ops"});
        oroforge::test::Command program = command(words);
        program.program = RTTSCRIPT_PROGRAM;
        return run(program);
    }

    /** What both kinds of check say of a script. */
    std::string checked(const std::string& text) {
        const oroforge::test::Outcome check = outcome({"--check"}, text), dryRun = outcome({"--dry-run"}, text);
        EXPECT_EQ(check.err, dryRun.err);
        EXPECT_EQ(check.err.find(": error: ") == std::string::npos ? 0 : 255, check.status);
        EXPECT_EQ(check.status, dryRun.status);
        return check.err;
    }
};

}  // namespace deployer_test

#endif
