// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A crash in a component names the component.
#include "deployer_program.hpp"

#include <gmock/gmock.h>

namespace {

using namespace oroforge::test;
using testing::AllOf;
using testing::HasSubstr;

class Crash : public deployer_test::DeployerInDirectory {
protected:
    Outcome crashIn(const std::string& where, const std::string& lastLine = "bad.start()\n") {
        directory_.write("app.ops",
                         "import(\"deploycrash\")\n"
                         "loadComponent(\"bad\", \"deploycrash::Crashing\")\n"
                         "setActivity(\"bad\", 0.01, 0, ORO_SCHED_OTHER)\n"
                         "bad.where = \"" +
                             where + "\"\nbad.configure()\n" + lastLine + "waitForInterrupt()\n");
        return run(command({"-s", "app.ops"}));
    }
};

TEST_F(Crash, InUpdateHookNamesComponentHookAndPlace) {
    const Outcome outcome = crashIn("update");
    EXPECT_NE(0, outcome.status);
    EXPECT_THAT(outcome.err,
                HasSubstr("error: component 'bad' crashed in updateHook(): it used memory that it has no access "
                          "to (SIGSEGV), at address 0x0\n"));
    EXPECT_THAT(outcome.err, HasSubstr("libdeploycrash-"));
}

TEST_F(Crash, InConfigureHook) {
    EXPECT_THAT(crashIn("configure").err, HasSubstr("error: component 'bad' crashed in configureHook(): "));
}

TEST_F(Crash, InAnOperationOfItsOwnThread) {
    EXPECT_THAT(crashIn("nowhere", "bad.start()\nbad.crash()\n").err, HasSubstr("error: component 'bad' crashed in "));
}

TEST_F(Crash, ByAbort) {
    EXPECT_THAT(crashIn("abort").err,
                HasSubstr("error: component 'bad' crashed in updateHook(): abort() was called (SIGABRT)\n"));
}

TEST_F(Crash, WhereTheStackIsUsedUp) {
    for (const std::string hook : {"configure", "update"}) {
        const Outcome outcome = crashIn("deep " + hook);
        EXPECT_EQ(128 + SIGSEGV, outcome.status) << hook;
        EXPECT_THAT(outcome.err, AllOf(HasSubstr("error: component 'bad' crashed in " + hook +
                                                 "Hook(): it used up the stack of its thread"),
                                       HasSubstr("libdeploycrash-")))
            << hook;
    }
}

TEST_F(Crash, OfADestructorThatThrows) {
    directory_.write("app.ops",
                     "import(\"deployfault\")\n"
                     "loadComponent(\"bad\", \"deployfault::Throwing\")\n"
                     "bad.where = \"destructor\"\n");
    Command program = command({"-s", "app.ops"});
    program.program = RTTSCRIPT_PROGRAM;
    const Outcome outcome = run(program);
    EXPECT_NE(0, outcome.status);
    EXPECT_THAT(outcome.err, HasSubstr("thrown in destructor"));
    EXPECT_THAT(outcome.err, HasSubstr("error: component 'bad' crashed in its destructor: abort() was called"));
}

}  // namespace
