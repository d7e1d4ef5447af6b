// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Each script of the corpus in every way a component can run it: from a file, as text, in a program of its own.
#include "corpus_file.hpp"
#include "robot.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/scripting/check.hpp>
#include <support/golden.hpp>
#include <support/temp_dir.hpp>
#include <unit/flow/log_capture.hpp>

#include <gmock/gmock.h>

#include <iostream>
#include <sstream>

namespace {

using namespace scripting_corpus;
using oroforge::test::caseName;
using oroforge::test::readFile;

/** Which differ line by line in the message of a failure. */
std::string lines(const std::vector<std::string>& notes) {
    std::string text;
    for (const std::string& note : notes) text += note + "\n";
    return text;
}

class Corpus : public testing::TestWithParam<std::string> {
protected:
    Corpus() {
        loadTypesAndScripting();
        EXPECT_TRUE(robot.loadService("scripting"));
    }

    bool call(const std::string& operation, const std::string& argument) {
        RTT::OperationCaller<bool(const std::string&)> caller(robot.provides("scripting")->getOperation(operation));
        EXPECT_TRUE(caller.ready()) << operation;
        return caller.ready() && caller(argument);
    }
    void expectNotes(const std::string& script) const {
        EXPECT_EQ(lines(expectedNotes(script)), lines(robot.notes()));
        if (HasFailure()) std::cerr << log_.text();
    }
    void runFile(const std::string& folder) {
        const std::filesystem::path file = corpusPath(folder, GetParam());
        EXPECT_TRUE(call("runScript", file.string()));
        expectNotes(readFile(file));
    }
    void evaluate(const std::string& folder) {
        const std::string script = readFile(corpusPath(folder, GetParam()));
        EXPECT_TRUE(call("eval", script));
        expectNotes(script);
    }
    /** Looking through it finds no error, and executes nothing. */
    void check(const std::string& folder) {
        std::ostringstream messages;
        EXPECT_TRUE(RTT::scripting::checkScript(corpusPath(folder, GetParam()).string(), robot, messages))
            << messages.str();
        EXPECT_THAT(messages.str(), testing::Not(testing::HasSubstr("error:")));
        EXPECT_EQ("", lines(robot.notes()));
    }

    flow_test::LogCapture log_;
    Robot robot;
};

class Statements : public Corpus {};

TEST_P(Statements, AreLookedThrough) { check("statements"); }

TEST_P(Statements, OfAFile) { runFile("statements"); }

TEST_P(Statements, OfAText) { evaluate("statements"); }

TEST_P(Statements, OfAProgram) {
    const std::string script = readFile(corpusPath("statements", GetParam()));
    ASSERT_TRUE(call("loadProgramText", "program corpus {\n" + script + "\n}\n")) << log_.text();
    ASSERT_TRUE(call("startProgram", "corpus"));
    for (int i = 0; i < 1000 && call("isProgramRunning", "corpus"); ++i) robot.step(1);
    EXPECT_FALSE(call("isProgramRunning", "corpus")) << "does not end";
    EXPECT_FALSE(call("inProgramError", "corpus"));
    expectNotes(script);
}

INSTANTIATE_TEST_SUITE_P(Corpus, Statements, testing::ValuesIn(corpusNames("statements")), caseName);

class Definitions : public Corpus {};

TEST_P(Definitions, AreLookedThrough) { check("definitions"); }

TEST_P(Definitions, InAFile) { runFile("definitions"); }

TEST_P(Definitions, InAText) { evaluate("definitions"); }

INSTANTIATE_TEST_SUITE_P(Corpus, Definitions, testing::ValuesIn(corpusNames("definitions")), caseName);

}  // namespace
