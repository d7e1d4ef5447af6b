// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// --format=json and --format=sarif: what is reported, for other programs.
#include "deployer_program.hpp"

#include <nlohmann/json.hpp>
#include <support/golden.hpp>

#include <gmock/gmock.h>

namespace {

using namespace oroforge::test;
using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const char* const kHead =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<!DOCTYPE properties SYSTEM \"cpf.dtd\">\n"
    "<properties>\n"
    "<simple name=\"Import\" type=\"string\"><value>deploytest</value></simple>\n";

/** "app.xml:5:26 DEP031" */
std::string placeOf(const json& diagnostic) {
    return diagnostic.value("file", "") + ":" + std::to_string(diagnostic.value("line", 0)) + ":" +
           std::to_string(diagnostic.value("column", 0)) + " " + diagnostic["code"].get<std::string>();
}

std::vector<std::string> placesOf(const json& document) {
    std::vector<std::string> places;
    for (const json& diagnostic : document["diagnostics"]) places.push_back(placeOf(diagnostic));
    return places;
}

/** The same of SARIF. */
std::vector<std::string> placesOfResults(const json& log) {
    std::vector<std::string> places;
    for (const json& result : log["runs"][0]["results"]) {
        const json& place = result["locations"][0]["physicalLocation"];
        places.push_back(place["artifactLocation"]["uri"].get<std::string>() + ":" +
                         std::to_string(place["region"].value("startLine", 0)) + ":" +
                         std::to_string(place["region"].value("startColumn", 0)) + " " +
                         result["ruleId"].get<std::string>());
    }
    return places;
}

class Format : public deployer_test::DeployerInDirectory {
protected:
    void write(const std::string& file, const std::string& content) {
        directory_.write(file, kHead + content + "</properties>\n");
    }

    /** Faults of every kind of file. */
    std::vector<std::string> faultyFiles() {
        write("first.xml", "<struct name=\"one\" type=\"deploytest::Consumr\"></struct>\n");
        directory_.write("second.ops",
                         "import(\"deploytest\")\nloadComponent(\"two\", \"deploytest::Consumer\")\n"
                         "two.strat()\n");
        directory_.write(
            "bad.cpf",
            "<properties>\n<simple name=\"a\" type=\"double\"><value>much</value></simple>\n</properties>\n");
        write("third.xml",
              "<struct name=\"three\" type=\"deploytest::Consumer\">\n"
              "<simple name=\"PropertyFile\" type=\"string\"><value>bad.cpf</value></simple></struct>\n");
        return {"first.xml", "second.ops", "third.xml"};
    }
};

TEST_F(Format, ADryRunReportsFaultsOfXmlCpfAndScriptsInOneDocument) {
    std::vector<std::string> words = faultyFiles();
    words.insert(words.begin(), {"--dry-run", "--format=json"});
    const Outcome outcome = run(command(words));
    EXPECT_EQ(255, outcome.status);
    EXPECT_THAT(outcome.err, Not(HasSubstr("error")));
    const json document = json::parse(outcome.out);
    EXPECT_EQ(1, document["version"]);
    EXPECT_EQ("deployer", document["tool"]);
    EXPECT_THAT(placesOf(document),
                testing::ElementsAre("bad.cpf:2:39 CPF006", "first.xml:5:26 DEP031", "second.ops:3:5 OPS134"));
    EXPECT_THAT(document["diagnostics"][1]["message"], HasSubstr("did you mean 'deploytest::Consumer'?"));
    EXPECT_THAT(readFile(directory_ / "orocos.log"), HasSubstr("[DEP031]"));
}

TEST_F(Format, SarifHasTheSamePlacesAndTheExplanationsOfTheCodes) {
    std::vector<std::string> words = faultyFiles();
    words.insert(words.begin(), {"--dry-run", "--format", "sarif"});
    const Outcome outcome = run(command(words));
    EXPECT_EQ(255, outcome.status);
    const json log = json::parse(outcome.out);
    EXPECT_THAT(placesOfResults(log),
                testing::ElementsAre("bad.cpf:2:39 CPF006", "first.xml:5:26 DEP031", "second.ops:3:5 OPS134"));
    const json& invocation = log["runs"][0]["invocations"][0];
    EXPECT_EQ(255, invocation["exitCode"]);
    EXPECT_EQ(false, invocation["executionSuccessful"]);
    for (const json& rule : log["runs"][0]["tool"]["driver"]["rules"])
        EXPECT_FALSE(rule["help"]["text"].get<std::string>().empty()) << rule;
    Command check;
    check.program = "/usr/bin/python3";
    check.arguments = {(sourceRoot() / "tests/support/check_sarif.py").string(),
                       directory_.write("report.sarif", outcome.out).string()};
    EXPECT_EQ("", oroforge::test::run(check).out);
}

TEST_F(Format, WhatComponentsAndConsoleWriteGoesToStandardError) {
    directory_.write("app.ops",
                     "import(\"deploytest\")\nloadComponent(\"one\", \"deploytest::Consumer\")\none.start()\n");
    Command with = command({"--format=json", "-s", "app.ops"});
    with.input = "1 + 1\nquit\n";
    const Outcome outcome = run(with);
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_EQ(json::array(), json::parse(outcome.out)["diagnostics"]);
    EXPECT_THAT(outcome.err, HasSubstr("one: started"));
    EXPECT_THAT(outcome.err, HasSubstr("= 2"));
}

TEST_F(Format, AProgramThatRunsTellsErrorsAtOnceAndInTheDocument) {
    directory_.write("app.ops",
                     "import(\"deploytest\")\nloadComponent(\"one\", \"deploytest::RefusesToConfigure\")\n"
                     "configureComponent(\"one\")\n");
    Command with = command({"--format=json", "--strict", "app.ops"});
    with.program = RTTSCRIPT_PROGRAM;
    const Outcome outcome = run(with);
    EXPECT_EQ(255, outcome.status);
    const json document = json::parse(outcome.out);
    EXPECT_EQ("rttscript", document["tool"]);
    ASSERT_FALSE(document["diagnostics"].empty());
    const std::string place = placeOf(document["diagnostics"][0]);
    EXPECT_THAT(place, testing::StartsWith("app.ops:3:"));
    EXPECT_THAT(outcome.err, HasSubstr(place.substr(0, place.find(' ')) + ": error: ["));
}

TEST_F(Format, AFileThatCannotBeDeployedIsAnErrorWhateverTheReason) {
    directory_.write("app.lua", "error('no')\n");
    for (const char* file : {"app.lua", "absent.xml", "absent.ops", "app.txt.xmlx"}) {
        const Outcome outcome = run(command({"--format=json", "-s", file}));
        EXPECT_EQ(255, outcome.status);
        const json document = json::parse(outcome.out);
        ASSERT_FALSE(document["diagnostics"].empty()) << file;
        EXPECT_EQ("error", document["diagnostics"][0]["severity"]);
        EXPECT_EQ(file, document["diagnostics"][0]["file"]) << document;
    }
}

TEST_F(Format, AWrongCommandLineIsReportedInTheFormatItAsksFor) {
    const Outcome wrong = run(command({"--format=json", "--nonsense"}));
    EXPECT_EQ(255, wrong.status);
    EXPECT_THAT(wrong.err, IsEmpty());
    const json diagnostic = json::parse(wrong.out)["diagnostics"][0];
    EXPECT_EQ("deployer", diagnostic["code"]);
    EXPECT_THAT(diagnostic["message"], HasSubstr("--nonsense"));
    EXPECT_THAT(diagnostic["hint"], HasSubstr("--help"));
    EXPECT_EQ(0U, diagnostic.count("file"));
    const Outcome code = run(command({"--format=json", "--explain", "DEP999"}));
    EXPECT_EQ(255, code.status);
    EXPECT_EQ(0U, json::parse(code.out)["diagnostics"][0].count("file")) << code.out;
    const Outcome unknown = run(command({"--format=jsn"}));
    EXPECT_EQ(255, unknown.status);
    EXPECT_THAT(unknown.err, HasSubstr("unknown value 'jsn' of --format, expected 'text', 'json' or 'sarif'; did you "
                                       "mean 'json'?"));
    EXPECT_THAT(unknown.out, IsEmpty());
}

TEST_F(Format, HelpIsNoReportAndASummaryGoesAside) {
    EXPECT_THAT(run(command({"--format=json", "--help"})).out, testing::StartsWith("Usage: deployer"));
    write("app.xml", "<struct name=\"one\" type=\"deploytest::Consumer\"></struct>\n");
    const Outcome outcome = run(command({"--dry-run", "--format=json", "-s", "app.xml"}));
    EXPECT_EQ(0, outcome.status);
    EXPECT_EQ(json::array(), json::parse(outcome.out)["diagnostics"]);
    EXPECT_THAT(outcome.err, HasSubstr("1 component, 0 connections: ok"));
}

TEST_F(Format, ADocumentThatCannotBeWrittenIsAFailure) {
    write("app.xml", "<struct name=\"one\" type=\"deploytest::Consumer\"></struct>\n");
    Command shell = command({"-c", "exec \"$0\" --dry-run --format=json -s app.xml > /dev/full", DEPLOYER_PROGRAM});
    shell.program = "/bin/sh";
    const Outcome outcome = run(shell);
    EXPECT_EQ(255, outcome.status);
    EXPECT_THAT(outcome.err, HasSubstr("error: the report cannot be written: No space left on device"));
}

}  // namespace
