// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// rttscript as a user runs it.
#include "deployer_program.hpp"

#include <gmock/gmock.h>

namespace {

using namespace oroforge::test;
using testing::HasSubstr;
using testing::Not;

class RttScript : public deployer_test::DeployerInDirectory {
protected:
    Command script(const std::vector<std::string>& arguments) const {
        Command result = command(arguments);
        result.program = RTTSCRIPT_PROGRAM;
        return result;
    }
};

const char* const kOneComponent =
    "import(\"deploytest\")\n"
    "loadComponent(\"one\", \"deploytest::Consumer\")\n"
    "one.configure()\n"
    "one.start()\n";

TEST_F(RttScript, EndsAfterItsFilesAndTakesEverythingDown) {
    directory_.write("app.ops", kOneComponent);
    const Outcome outcome = run(script({"app.ops"}));
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("one: started\none: stopped\none: cleaned up\none: deleted\n"));
}

TEST_F(RttScript, AScriptThatWaitsEndsOnASignal) {
    directory_.write("app.ops", std::string(kOneComponent) + "waitForInterrupt()\n");
    ChildProcess program(script({"-s", "app.ops"}));
    EXPECT_TRUE(program.waitForOutput("waiting for an interrupt", std::chrono::seconds(20)));
    program.send(SIGTERM);
    const Outcome outcome = program.finish();
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("one: stopped\none: cleaned up\none: deleted\n"));
}

TEST_F(RttScript, ASignalThatComesBeforeTheScriptWaitsIsNotLost) {
    directory_.write("app.ops", std::string(kOneComponent) +
                                    "var int i = 0\n"
                                    "while (i < 3000000) { set i = i + 1 }\n"
                                    "waitForInterrupt()\n");
    ChildProcess program(script({"-s", "app.ops"}));
    EXPECT_TRUE(program.waitForOutput("one: started", std::chrono::seconds(20)));
    program.send(SIGTERM);
    const Outcome outcome = program.finish();
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("one: deleted\n"));
}

TEST_F(RttScript, FilesAfterAFailedOneAreNotTried) {
    directory_.write("wrong.ops", "no_such_thing()\n");
    directory_.write("app.ops", kOneComponent);
    const Outcome outcome = run(script({"wrong.ops", "app.ops"}));
    EXPECT_EQ(255, outcome.status);
    EXPECT_THAT(outcome.err, HasSubstr("wrong.ops:1:1: error:"));
    EXPECT_THAT(outcome.out, Not(HasSubstr("one:")));
}

}  // namespace
