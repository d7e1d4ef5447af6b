// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_CHECKED_SCRIPT_HPP
#define OROFORGE_TESTS_CHECKED_SCRIPT_HPP

#include "reporting_script.hpp"

#include <string>

namespace deployer_test {

const std::string kImport = "import(\"deploytest\")\n";
const std::string kOne = kImport + "loadComponent(\"one\", \"deploytest::Consumer\")\n";

/** Runs and checks scripts. */
class CheckedScript : public ReportingScript {
protected:
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
