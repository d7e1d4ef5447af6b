// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Components and libraries that misbehave: the message names them, the exit status is right, nothing is left running.
#include "deployer_program.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <thread>

namespace {

using namespace oroforge::test;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class Fault : public deployer_test::DeployerInDirectory {
protected:
    static std::string page(const std::string& component) {
        return "<properties>\n"
               "<simple name=\"Import\" type=\"string\"><value>deployfault</value></simple>\n" +
               component + "</properties>\n";
    }
    static std::string component(const std::string& name, const std::string& where, const std::string& more = "") {
        return "<struct name=\"" + name +
               "\" type=\"deployfault::Throwing\">\n"
               "<struct name=\"Activity\" type=\"Activity\"><simple name=\"Period\" type=\"double\"><value>0.01</value>"
               "</simple></struct>\n"
               "<struct name=\"Properties\" type=\"PropertyBag\"><simple name=\"where\" type=\"string\"><value>" +
               where +
               "</value></simple></struct>\n"
               "<simple name=\"AutoConf\" type=\"boolean\"><value>1</value></simple>\n"
               "<simple name=\"AutoStart\" type=\"boolean\"><value>1</value></simple>\n" +
               more + "</struct>\n";
    }
    /** Of a first component that is well, and a second one that throws there. */
    Outcome runWith(const std::string& where) {
        directory_.write("app.xml", page(component("well", "") + component("bad", where)));
        Command program = command({"-s", "app.xml"});
        program.program = RTTSCRIPT_PROGRAM;
        return run(program);
    }
};

TEST_F(Fault, AHookThatThrowsBeforeItRunsUndoesTheFile) {
    for (const std::string where : {"configure", "start"}) {
        const Outcome outcome = runWith(where);
        EXPECT_EQ(255, outcome.status) << where;
        EXPECT_THAT(outcome.err,
                    AllOf(HasSubstr("app.xml:9:15: error:"), HasSubstr("component 'bad': " + where + "() threw"),
                          HasSubstr("thrown in " + where)))
            << where;
        EXPECT_THAT(outcome.out, AllOf(HasSubstr("well: deleted\n"), HasSubstr("bad: deleted\n"))) << where;
    }
}

TEST_F(Fault, AHookThatThrowsWhileItRunsIsToldAndLeavesTheOthersAlone) {
    directory_.write("app.xml", page(component("well", "") + component("bad", "update")));
    const Outcome outcome = runUntil("bad: exception", {"-s", "app.xml"}, SIGTERM);
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("bad"), HasSubstr("updateHook()"), HasSubstr("thrown in update")));
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("well: deleted\n"), HasSubstr("bad: deleted\n")));
}

TEST_F(Fault, WhatThrowsWhileItIsTakenDownDoesNotKeepTheRestFromBeingTakenDown) {
    for (const std::string where : {"stop", "cleanup"}) {
        const Outcome outcome = runWith(where);
        EXPECT_THAT(outcome.err, AllOf(HasSubstr("bad"), HasSubstr("thrown in " + where))) << where;
        EXPECT_THAT(outcome.out, AllOf(HasSubstr("well: deleted\n"), HasSubstr("bad: deleted\n"))) << where;
    }
}

#ifndef __SANITIZE_ADDRESS__  // it needs the memory itself
// As where a user may have few threads; that limit does not hold for root, so here memory for their stacks is short.
TEST_F(Fault, WithoutEnoughThreadsTheDeploymentIsUndoneAndSaysWhy) {
    std::string components;
    for (int i = 0; i != 50; ++i) components += component("c" + std::to_string(i), "");
    directory_.write("app.xml", page(components));
    Command limited = command({});
    limited.arguments = {"-c", "ulimit -s 65536; ulimit -v 1000000; exec " + limited.program + " -s app.xml"};
    limited.program = "/bin/sh";
    const Outcome outcome = run(limited);
    EXPECT_EQ(255, outcome.status);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("cannot create thread"), HasSubstr("(EAGAIN)"), HasSubstr("ulimit -u"),
                                   Not(HasSubstr("bad_alloc"))));
    EXPECT_THAT(outcome.out, HasSubstr("c0: deleted\n"));
}
#endif

TEST_F(Fault, ALibraryWithUnresolvedSymbolsIsNamedWithTheSymbol) {
    directory_.write("app.xml",
                     "<properties>\n<simple name=\"Import\" type=\"string\"><value>deploybroken</value></simple>\n"
                     "</properties>\n");
    const Outcome outcome = run(command({"--check", "-s", "app.xml"}));
    EXPECT_EQ(255, outcome.status);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("app.xml:2:"), HasSubstr("could not import 'deploybroken'"),
                                   HasSubstr("definedNowhere")));
}

TEST_F(Fault, AFileThatIsBeingSavedWhenTheProcessIsKilledIsWholeOrAsBefore) {
    const std::string before =
        "<properties>\n<simple name=\"where\" type=\"string\"><value></value></simple>\n</properties>\n";
    directory_.write(
        "app.xml", page(component("well", "",
                                  "<simple name=\"UpdateProperties\" type=\"string\"><value>well.cpf</value></simple>\n"
                                  "<simple name=\"AutoSave\" type=\"boolean\"><value>1</value></simple>\n")));
    Command program = command({"-s", "app.xml"});
    program.program = RTTSCRIPT_PROGRAM;
    directory_.write("well.cpf", before);
    // The shortest of some: one that others kept from the processor or the disk would make all that follow wait too long.
    auto undisturbed = std::chrono::steady_clock::duration::max();
    for (int i = 0; i != 3; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        EXPECT_EQ(0, run(program).status);
        undisturbed = std::min(undisturbed, std::chrono::steady_clock::now() - begin);
    }
    int saved = 0;
    // Later and later, until one was not killed in time.
    for (int attempt = 1; attempt <= 20 || (saved == 0 && attempt <= 200); ++attempt) {
        directory_.write("well.cpf", before);
        ChildProcess child(program);
        std::this_thread::sleep_for(undisturbed * attempt / 18);
        child.send(SIGKILL);
        (void)child.finish();
        const std::string after = readFile(directory_ / "well.cpf");
        if (after == before) continue;
        ++saved;
        EXPECT_THAT(after, HasSubstr("many"));
        EXPECT_EQ("</properties>\n", after.substr(after.size() - 14)) << after;
    }
    EXPECT_GT(saved, 0) << "none of the processes came as far as saving";
}

}  // namespace
