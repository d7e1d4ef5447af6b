// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <report/report.hpp>

#include <fstream>
#include <sstream>

#include <nlohmann/json.hpp>

#include <explain/explanations.hpp>
#include <report/parts.hpp>
#include <support/temp_dir.hpp>

#include <gtest/gtest.h>

using namespace oroforge;
using nlohmann::json;

namespace {

const report::Tool kTool{"tool", "1.2", &explain::explanations()};

json jsonOf(const diag::Sink& sink) { return json::parse(report::jsonReport(kTool, sink)); }
json firstResult(const diag::Sink& sink) {
    return json::parse(report::sarifReport(kTool, sink))["runs"][0]["results"][0];
}

}  // namespace

TEST(Uri, IsPercentEncoded) {
    EXPECT_EQ(report::uriOf("a/b-c_d.hpp"), "a/b-c_d.hpp");
    EXPECT_EQ(report::uriOf("a b/\xC3\xA4#1.hpp"), "a%20b/%C3%A4%231.hpp");
    EXPECT_EQ(report::uriOf("/a/100%.hpp"), "file:///a/100%25.hpp");
    EXPECT_EQ(report::uriOf("c:d.hpp"), "c%3Ad.hpp") << "no scheme of a URI";
    EXPECT_EQ(report::uriOf("../x.hpp"), "../x.hpp");
}

TEST(WantedFormat, IsFoundInAnyCommandLine) {
    using report::Format;
    EXPECT_EQ(report::wantedFormat({}), Format::Text);
    EXPECT_EQ(report::wantedFormat({"--wrong", "--format=json"}), Format::Json);
    EXPECT_EQ(report::wantedFormat({"--format", "sarif", "x"}), Format::Sarif);
    EXPECT_EQ(report::wantedFormat({"--format=xml"}), Format::Text);
    EXPECT_EQ(report::wantedFormat({"--", "--format=json"}), Format::Text);
    EXPECT_EQ(report::wantedFormat({"--format"}), Format::Text);
}

TEST(JsonReport, HoldsAllThatIsKnown) {
    diag::Sink sink;
    diag::Diagnostic& error = sink.error({"f.hpp", 2, 3}, "TK014", "is a union");
    error.note({"g.hpp", 4, 5}, "through this").hint("use a struct");
    error.fixes = {{{"f.hpp", 2, 1}, {"f.hpp", 2, 6}, "struct"}};
    EXPECT_EQ(jsonOf(sink), json::parse(R"({
        "version": 1, "tool": "tool", "toolVersion": "1.2",
        "diagnostics": [{
            "severity": "error", "code": "TK014", "message": "is a union", "file": "f.hpp", "line": 2, "column": 3,
            "notes": [{"message": "through this", "file": "g.hpp", "line": 4, "column": 5}],
            "hint": "use a struct",
            "fixes": [{"file": "f.hpp", "line": 2, "column": 1, "endLine": 2, "endColumn": 6, "replacement": "struct"}]
        }]})"));
}

TEST(JsonReport, LeavesOutWhatIsUnknown) {
    diag::Sink sink;
    sink.warning({"tool"}, "TK003", "wrong option");
    sink.error({"f.hpp", 1, 0}, "", "of the compiler");
    const json all = jsonOf(sink)["diagnostics"];
    EXPECT_EQ(all[0]["code"], "clang");
    EXPECT_EQ(all[0].count("column"), 0U);
    EXPECT_EQ(all[1]["severity"], "warning");
    EXPECT_EQ(all[1].count("file"), 0U) << "the program is no file";
}

TEST(JsonReport, IsValidWhateverBytesAMessageHolds) {
    diag::Sink sink;
    sink.error({"f.hpp", 1, 1}, "X", "bad \xFF\"\\\n byte");
    EXPECT_EQ(jsonOf(sink)["diagnostics"][0]["message"], "bad \xEF\xBF\xBD\"\\\n byte");
    EXPECT_FALSE(report::sarifReport(kTool, sink).empty());
}

TEST(SarifReport, OfNothingIsARunWithoutResults) {
    const json log = json::parse(report::sarifReport(kTool, {}));
    EXPECT_EQ(log["version"], "2.1.0");
    EXPECT_EQ(log["runs"][0]["results"], json::array());
    EXPECT_EQ(log["runs"][0]["invocations"][0]["executionSuccessful"], true);
    EXPECT_EQ(log["runs"][0]["tool"]["driver"]["name"], "tool");
}

TEST(SarifReport, ListsEachRuleOnceWithItsExplanation) {
    diag::Sink sink;
    sink.error({"f.hpp", 1, 1}, "TK014", "one");
    sink.error({"f.hpp", 2, 1}, "", "two");
    sink.error({"f.hpp", 3, 1}, "TK014", "three");
    const json run = json::parse(report::sarifReport(kTool, sink))["runs"][0];
    const json& rules = run["tool"]["driver"]["rules"];
    ASSERT_EQ(rules.size(), 2U);
    EXPECT_EQ(rules[0]["shortDescription"]["text"], "a union");
    EXPECT_EQ(run["results"][1]["ruleIndex"], 1);
    EXPECT_EQ(run["results"][2]["ruleIndex"], 0);
}

TEST(Reports, TakeCodeAndExitStatusFromTheTool) {
    diag::Sink sink;
    sink.warning({}, "", "of the program");
    const report::Tool tool{"tool", "1.2", nullptr, "own", 7};
    EXPECT_EQ(json::parse(report::jsonReport(tool, sink))["diagnostics"][0]["code"], "own");
    const json run = json::parse(report::sarifReport(tool, sink))["runs"][0];
    EXPECT_EQ(run["results"][0]["ruleId"], "own");
    EXPECT_EQ(run["invocations"][0]["exitCode"], 7);
    EXPECT_EQ(run["invocations"][0]["executionSuccessful"], false);
}

TEST(SarifReport, CountsColumnsInCharacters) {
    const test::TempDir dir;
    const std::string file = dir.write("f.hpp", "\xC3\xA4\xC3\xB6 x y\n").string();
    diag::Sink sink;
    diag::Diagnostic& error = sink.error({file, 1, 6}, "X", "at x");
    error.fixes = {{{file, 1, 6}, {file, 1, 7}, ""}};
    const json result = firstResult(sink);
    EXPECT_EQ(result["locations"][0]["physicalLocation"]["region"]["startColumn"], 4);
    const json& replacement = result["fixes"][0]["artifactChanges"][0]["replacements"][0];
    EXPECT_EQ(replacement["deletedRegion"]["startColumn"], 4);
    EXPECT_EQ(replacement["deletedRegion"]["endColumn"], 5);
    EXPECT_EQ(replacement.count("insertedContent"), 0U);
}

TEST(SarifReport, NotesAreRelatedLocationsAndTheirFixesAreAlternatives) {
    diag::Sink sink;
    diag::Diagnostic& error = sink.error({"f.hpp", 1, 1}, "X", "unknown");
    error.note({"f.hpp", 2, 1}, "did you mean 'y'").notes.back().fixes = {{{"f.hpp", 1, 1}, {"f.hpp", 1, 2}, "y"}};
    error.note({"f.hpp", 3, 1}, "did you mean 'z'").notes.back().fixes = {{{"f.hpp", 1, 1}, {"f.hpp", 1, 2}, "z"}};
    const json result = firstResult(sink);
    EXPECT_EQ(result["relatedLocations"][1]["message"]["text"], "did you mean 'z'");
    ASSERT_EQ(result["fixes"].size(), 2U);
    EXPECT_EQ(result["fixes"][1]["description"]["text"], "did you mean 'z'");
}

TEST(Write, TellsWhetherItCould) {
    std::ofstream full("/dev/full");
    std::ostringstream err;
    EXPECT_FALSE(report::write(report::Format::Json, kTool, {}, full, err));
    EXPECT_TRUE(report::write(report::Format::Text, kTool, {}, full, err));
}
