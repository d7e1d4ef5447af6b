// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_REPORTING_SCRIPT_HPP
#define OROFORGE_TESTS_REPORTING_SCRIPT_HPP

#include "deployer_program.hpp"

#include <string>
#include <vector>

namespace deployer_test {

/** Four lines. */
const std::string kTwo =
    "import(\"deploytest\")\nvar string none = \"none\"\nloadComponent(\"one\", \"deploytest::Consumer\")\n"
    "loadComponent(\"two\", \"deploytest::Producer\")\n";

/** Runs scripts. */
class ReportingScript : public DeployerInDirectory {
protected:
    oroforge::test::Outcome outcome(const std::vector<std::string>& options, const std::string& text) {
        directory_.write("app.ops", text);
        std::vector<std::string> words = options;
        words.insert(words.end(), {"-s", "app.ops"});
        oroforge::test::Command program = command(words);
        program.program = RTTSCRIPT_PROGRAM;
        return run(program);
    }
};

}  // namespace deployer_test

#endif
