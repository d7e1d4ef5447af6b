// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
//
// A case is a directory <kind>/<name>/ with
//     args              command lines of orocreate-pkg, one per line; run one after the other
//     other files       copied into the empty directory in which it runs
//     expected/         status.txt (if not 0), stdout.txt, stderr.txt (if not empty), files/ (what it made or changed)
#include <sstream>

#include <gtest/gtest.h>
#include <support/child_process.hpp>
#include <support/golden.hpp>
#include <support/temp_dir.hpp>

namespace fs = std::filesystem;

namespace oroforge::test {
namespace {

std::map<std::string, std::string> inputsOf(const fs::path& golden) {
    auto files = readTree(golden);
    for (auto it = files.begin(); it != files.end();) {
        const bool input = it->first != "args" && it->first.compare(0, 9, "expected/") != 0;
        it = input ? std::next(it) : files.erase(it);
    }
    return files;
}

std::vector<std::string> wordsOf(const std::string& line) {
    std::istringstream in(line);
    return {std::istream_iterator<std::string>(in), {}};
}

/// Everything a case did, as the files of its expected/ directory.
std::map<std::string, std::string> observed(const fs::path& golden) {
    const TempDir dir;
    const auto inputs = inputsOf(golden);
    for (const auto& [name, text] : inputs) dir.write(name, text);
    std::map<std::string, std::string> result;
    for (const std::string& line : splitLines(readFile(golden / "args"))) {
        Command command;
        command.program = OROCREATE_PKG;
        command.arguments = wordsOf(line);
        command.directory = dir.path();
        const Outcome outcome = run(command);
        if (!outcome.out.empty()) result["stdout.txt"] += outcome.out;
        if (!outcome.err.empty()) result["stderr.txt"] += outcome.err;
        if (outcome.status != 0) result["status.txt"] += std::to_string(outcome.status) + "\n";
    }
    for (const auto& [name, text] : readTree(dir.path())) {
        const auto input = inputs.find(name);
        if (input == inputs.end() || input->second != text) result["files/" + name] = text;
    }
    return result;
}

class OrocreatePkgGolden : public testing::TestWithParam<std::string> {};

TEST_P(OrocreatePkgGolden, GivesWhatIsExpected) {
    const std::string path = GetParam();
    const fs::path golden = sourceRoot() / "tests/golden" / path;

    expectGoldenTree(golden / "expected", observed(golden));
}

std::vector<std::string> allCases() {
    std::vector<std::string> paths;
    for (const char* kind :
         {"manifest_model", "manifest_view", "manifest_diagnostics", "component", "package", "describe", "update"}) {
        for (const std::string& name : goldenCases(kind)) paths.push_back(std::string(kind) + "/" + name);
    }
    return paths;
}

INSTANTIATE_TEST_SUITE_P(Golden, OrocreatePkgGolden, testing::ValuesIn(allCases()), caseName);

}  // namespace
}  // namespace oroforge::test
