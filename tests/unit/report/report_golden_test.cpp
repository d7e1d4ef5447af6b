// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// tests/golden/diagnostics_report: the JSON and the SARIF about headers. All SARIF that typegen writes about these and
// about the headers of tests/golden/diagnostics_types is valid.
#include <sstream>

#include <support/child_process.hpp>
#include <support/golden.hpp>
#include <support/run_typegen.hpp>
#include <support/temp_dir.hpp>

namespace fs = std::filesystem;
using namespace oroforge::test;

namespace {

/// What typegen reports about a case, each of which has an error.
std::string reportOf(const fs::path& dir, const std::string& format) {
    const Ran ran = runTypegenIn(dir, {format});
    EXPECT_EQ(ran.status, 1);
    EXPECT_EQ(ran.err, "");
    return ran.out;
}

/// The version of this build taken out, and texts of explanations, which have a test of their own.
std::string comparable(const std::string& report) {
    std::istringstream lines(report);
    std::string text;
    for (std::string line; std::getline(lines, line);) {
        const std::size_t key = line.find_first_not_of(' ');
        const auto is = [&](const char* name) { return line.compare(key, std::string(name).size(), name) == 0; };
        if (key != std::string::npos && is("\"toolVersion\""))
            line = line.substr(0, key) + "\"toolVersion\": \"VERSION\",";
        if (key == 10 && is("\"version\"")) line = line.substr(0, key) + "\"version\": \"VERSION\",";
        text += line + "\n";
    }
    return text;
}

class Report : public testing::TestWithParam<std::string> {};

}  // namespace

TEST_P(Report, IsWrittenInBothFormats) {
    const fs::path dir = goldenDir("diagnostics_report", GetParam());
    expectGolden(dir / "expected/report.json", comparable(reportOf(dir, "--format=json")));
    expectGolden(dir / "expected/report.sarif", comparable(reportOf(dir, "--format=sarif")));
}

INSTANTIATE_TEST_SUITE_P(Golden, Report, testing::ValuesIn(goldenCases("diagnostics_report")), caseName);

TEST(OrocreatePkg, ReportsInTheSameFormats) {
    const fs::path dir = goldenDir("manifest_diagnostics", "bad_values");
    const TempDir place;
    for (const std::string format : {"json", "sarif"}) {
        Command create;
        create.program = OROCREATE_PKG;
        create.directory = dir;
        create.arguments = {"--format", format, "--generate", "m.xml", "--output", (place / "out").string()};
        const Outcome outcome = run(create);
        EXPECT_EQ(outcome.status, 1);
        EXPECT_EQ(outcome.err, "");
        EXPECT_NE(outcome.out.find("\"OM"), std::string::npos) << outcome.out;
        Command check;
        check.program = "/usr/bin/python3";
        check.arguments = {(sourceRoot() / "tests/support/check_sarif.py").string(),
                           place.write("log.sarif", outcome.out).string()};
        if (format == "sarif") {
            EXPECT_EQ(run(check).status, 0) << run(check).out;
        }
        create.arguments = {"--format", format, "--dump=model", "--generate", "m.xml"};
        EXPECT_EQ(run(create).status, 1);
        EXPECT_NE(run(create).out.find("OC001"), std::string::npos);
    }
}

TEST(Sarif, IsValidForAllCases) {
    const TempDir dir;
    Command check;
    check.program = "/usr/bin/python3";
    check.arguments = {(sourceRoot() / "tests/support/check_sarif.py").string()};
    for (const char* kind : {"diagnostics_types", "diagnostics_report"}) {
        for (const std::string& name : goldenCases(kind)) {
            const fs::path file = dir.write(name + ".sarif", reportOf(goldenDir(kind, name), "--format=sarif"));
            check.arguments.push_back(file.string());
        }
    }
    const Outcome outcome = run(check);
    EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
    // That the check does see faults:
    const fs::path wrong =
        dir.write("wrong.sarif", R"({"version": "2.1.0", "runs": [{"results": [{"level": "fatal"}]}]})");
    check.arguments = {check.arguments[0], wrong.string()};
    EXPECT_EQ(run(check).status, 1);
}
