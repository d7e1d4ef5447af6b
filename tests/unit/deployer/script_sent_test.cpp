// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What is told of operations that a script sends and that fail, and of calls within calls.
#include "reporting_script.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace {

using namespace oroforge::test;
using deployer_test::kTwo;
using deployer_test::ReportingScript;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

const std::string kReason = "could not connect peers: no component 'none'; did you mean 'one'?\n";
const std::string kSent = "connectPeers.send(\"one\", none)\n";
const std::string kSlowly = "setActivity(\"Deployer\", 0.01, 0, ORO_SCHED_OTHER)\nstart()\n";

long lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

TEST_F(ReportingScript, WhatIsSentAndForgottenTellsItsPlace) {
    const Outcome found = outcome({}, kTwo + kSent);
    EXPECT_EQ("app.ops:5:1: warning: [OPS420] " + kReason + kSent + "^\n", found.err);
    EXPECT_EQ(0, found.status);
    const Outcome strict = outcome({"--strict"}, kTwo + kSent);
    EXPECT_EQ("app.ops:5:1: error: [OPS420] " + kReason + kSent + "^\n", strict.err);
    EXPECT_EQ(255, strict.status);
}

TEST_F(ReportingScript, OperationsOfServicesThatAreSentTellTheirPlaces) {
    for (const std::string call : {"one.loadService.send(none)", "require.send(none)", "startComponents.send()",
                                   "scripting.runScript.send(none)", "one.marshalling.loadProperties.send(none)"}) {
        const std::string text = kTwo + "loadService(\"one\", \"marshalling\")\n" + call + "\n";
        const Outcome found = outcome({}, text), strict = outcome({"--strict"}, text);
        EXPECT_THAT(found.err, HasSubstr("app.ops:6:1: warning: [OPS420] ")) << call;
        EXPECT_THAT(found.err, Not(HasSubstr("[ ERROR"))) << call;
        EXPECT_EQ(0, found.status) << call;
        EXPECT_THAT(strict.err, HasSubstr("app.ops:6:1: error: [OPS420] ")) << call;
        EXPECT_EQ(255, strict.status) << call;
    }
}

TEST_F(ReportingScript, WhatWasSentBeforeByTheSameHandleIsNotCollectedWithIt) {
    const std::string text = kTwo + "var SendHandle s\ns = " + kSent + "s = one.isRunning.send()\ns.collect()\n";
    const Outcome strict = outcome({"--strict"}, text);
    EXPECT_EQ("app.ops:6:5: error: [OPS420] " + kReason + "s = " + kSent + "    ^\n", strict.err);
    EXPECT_EQ(255, strict.status);
    EXPECT_EQ(0, outcome({}, text).status);
}

TEST_F(ReportingScript, WhatIsSentAndCollectedFailsTheStatementThatIgnoresTheResult) {
    const std::string send = kTwo + "var SendHandle s\ns = " + kSent;
    for (const std::string collect : {"s.collect()\n", "while s.collectIfDone() == SendNotReady do yield\n"}) {
        const Outcome found = outcome({}, send + collect + "one.configure()\n");
        EXPECT_THAT(found.err, StartsWith("app.ops:6:5: warning: [OPS420] " + kReason));
        EXPECT_THAT(found.out, HasSubstr("one: configured"));
        EXPECT_EQ(0, found.status);
        const Outcome strict = outcome({"--strict"}, send + collect + "one.configure()\n");
        EXPECT_THAT(strict.err, StartsWith("app.ops:6:5: error: [OPS400] " + kReason + "s = " + kSent +
                                           "    ^\napp.ops:7:" + (collect[0] == 's' ? "1" : "25") +
                                           ": note: it is collected here\n" + collect));
        EXPECT_EQ(6, lines(strict.err)) << strict.err;
        EXPECT_EQ(255, strict.status);
        EXPECT_THAT(strict.out, Not(HasSubstr("one: configured")));
    }
    const Outcome looked =
        outcome({"--strict"}, send + "var bool b = true\ns.collect(b)\nif !b then one.configure()\n");
    EXPECT_EQ(3, lines(looked.err)) << looked.err;
    EXPECT_THAT(looked.err, StartsWith("app.ops:6:5: warning: [OPS420] " + kReason));
    EXPECT_THAT(looked.out, HasSubstr("one: configured"));
    EXPECT_EQ(0, looked.status);
    const Outcome never = outcome({"--strict"}, send);
    EXPECT_EQ(3, lines(never.err)) << never.err;
    EXPECT_THAT(never.err, StartsWith("app.ops:6:5: error: [OPS420] " + kReason));
    EXPECT_EQ(255, never.status);
}

TEST_F(ReportingScript, ACommandThatFailsFailsItsStatement) {
    const std::string command = "connectPeers.cmd(\"one\", none)\n";
    const Outcome found = outcome({}, kTwo + command);
    EXPECT_EQ("app.ops:5:1: warning: [OPS420] " + kReason + command + "^\n", found.err);
    EXPECT_EQ(0, found.status);
    const Outcome strict = outcome({"--strict"}, kTwo + command);
    EXPECT_EQ("app.ops:5:1: error: [OPS400] " + kReason + command + "^\n", strict.err);
    EXPECT_EQ(255, strict.status);
    const Outcome caught = outcome({"--strict"}, kTwo + "try " + command + "catch { one.configure() }\n");
    EXPECT_THAT(caught.out, HasSubstr("one: configured"));
    EXPECT_EQ(0, caught.status) << caught.err;
}

TEST_F(ReportingScript, WhatIsSentAndDoesNotFailIsSilent) {
    const Outcome found =
        outcome({"--strict"}, kTwo +
                                  "var SendHandle s\nvar int i = 0\nwhile i < 200 {\n"
                                  "  s = connectPeers.send(\"one\", \"two\")\n  i = i + 1\n}\n"
                                  "s.collect()\nconnectPeers.cmd(\"one\", \"two\")\none.start.send()\n"
                                  "addPeer.send(\"one\", \"two\")\n");
    EXPECT_THAT(found.err, IsEmpty());
    EXPECT_EQ(0, found.status);
}

TEST_F(ReportingScript, WhatProgramsSendTellsItsPlace) {
    const std::string text = kTwo + "program p {\n  " + kSent + "  connectPeers.cmd(\"two\", none)\n}\n" + kSlowly +
                             "p.start()\nwhile p.isRunning() do yield\n";
    const Outcome found = outcome({}, text);
    EXPECT_THAT(found.err, HasSubstr("app.ops:6:3: warning: [OPS420] " + kReason + "  " + kSent + "  ^\n"));
    EXPECT_THAT(found.err, HasSubstr("app.ops:7:3: warning: [OPS420] " + kReason));
    const Outcome strict = outcome({"--strict"}, text);
    EXPECT_THAT(strict.err, HasSubstr("app.ops:6:3: error: [OPS420] " + kReason));
    EXPECT_THAT(strict.err, HasSubstr("app.ops:7:3: error: [OPS400] program 'p' of component 'Deployer' failed: " +
                                      kReason + "  connectPeers.cmd(\"two\", none)\n  ^\n"));
}

TEST_F(ReportingScript, ThePlaceOfTheInnermostCallComesFirst) {
    const std::string bad = "error: [OPS400] could not add a peer: no component 'none'; did you mean 'one'?\n";
    const std::string get = "string getIt() {\n  addPeer(\"one\", none)\n  return \"two\"\n}\n";
    for (const bool exported : {false, true}) {
        const std::string call = std::string("connectPeers(\"one\", ") + (exported ? "this." : "") + "getIt())\n";
        const Outcome strict = outcome({"--strict"}, kTwo + (exported ? "export " : "") + get + call);
        EXPECT_EQ("app.ops:6:3: " + bad +
                      "  addPeer(\"one\", none)\n  ^\n"
                      "app.ops:9:1: note: function 'getIt' of component 'Deployer' is called here\n" +
                      call + "^\n",
                  strict.err);
        EXPECT_EQ(255, strict.status);
    }
}

TEST_F(ReportingScript, ThePlaceOfACallInAFunctionOfAFunctionOfAProgramComesFirst) {
    const std::string functions = kTwo +
                                  "void inner() { addPeer(\"one\", none) }\nvoid outer() {\n  inner()\n}\n"
                                  "export void all() {\n  outer()\n}\n";
    const Outcome found = outcome({"--strict"}, functions + "program p {\n  this.all()\n}\n" + kSlowly +
                                                    "p.start()\nwhile p.isRunning() do yield\n");
    EXPECT_THAT(found.err,
                HasSubstr("\napp.ops:5:16: error: [OPS400] program 'p' of component 'Deployer' failed: could not add a "
                          "peer: no component 'none'; did you mean 'one'?\nvoid inner() { addPeer(\"one\", none) }\n"
                          "               ^\n"
                          "app.ops:7:3: note: function 'inner' is called here\n  inner()\n  ^\n"
                          "app.ops:10:3: note: function 'outer' is called here\n  outer()\n  ^\n"
                          "app.ops:13:3: note: function 'all' of component 'Deployer' is called here\n"
                          "  this.all()\n  ^\n"));
    const Outcome machine =
        outcome({"--strict"}, functions +
                                  "StateMachine M { initial state A { entry {\n  all() } } final state B { } }\n"
                                  "RootMachine M m\nm.activate()\n");
    EXPECT_THAT(machine.err, HasSubstr("\napp.ops:5:16: error: [OPS400] state machine 'm' failed in state 'A': could"));
    const Outcome sent =
        outcome({"--strict"}, functions +
                                  "var SendHandle h\nh = all.send()\ntry h.collect() catch { one.configure() }\n"
                                  "h = all.send()\nh.collect()\n");
    EXPECT_THAT(sent.err,
                StartsWith("app.ops:5:16: error: [OPS400] function 'all' of component 'Deployer' failed: could"));
    EXPECT_THAT(sent.err, HasSubstr("\napp.ops:16:1: note: function 'all' of component 'Deployer' is called here\n"));
    EXPECT_THAT(sent.out, HasSubstr("one: configured"));
}

}  // namespace
