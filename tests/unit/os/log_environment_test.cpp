// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a process finds in the environment, and what its log file then has.
#include "log_probe_run.hpp"

#include <cstdlib>
#include <gmock/gmock.h>

using os_test::Environment;
using os_test::Probe;
using testing::HasSubstr;
using testing::Not;

TEST(LogFile, KeepsInfoAndWorseWithoutFlush) {
    const Probe p;
    EXPECT_EQ(p.outcome.status, 0);
    EXPECT_THAT(p.file, HasSubstr("[ Info   ][probe] message 5\n"));
    EXPECT_THAT(p.file, Not(HasSubstr("message 6")));
    EXPECT_THAT(p.file, HasSubstr("ORO_LOGLEVEL is not set"));
    EXPECT_THAT(p.outcome.err, HasSubstr("[ Warning][probe] message 4\n"));
    EXPECT_THAT(p.outcome.err, Not(HasSubstr("message 5")));
}

TEST(LogFile, EnvironmentSetsTheLevel) {
    const Probe debug(Environment{{"ORO_LOGLEVEL", "7"}});  // Debug, not RealTime
    EXPECT_THAT(debug.outcome.err, HasSubstr("message 6"));
    EXPECT_THAT(debug.outcome.err, Not(HasSubstr("message 7")));
    EXPECT_THAT(debug.file, HasSubstr("message 6"));
    const Probe fatal(Environment{{"ORO_LOGLEVEL", "1"}});
    EXPECT_THAT(fatal.outcome.err, HasSubstr("message 1"));
    EXPECT_THAT(fatal.outcome.err, Not(HasSubstr("message 2")));
    EXPECT_THAT(fatal.file, HasSubstr("message 5"));
    const Probe never(Environment{{"ORO_LOGLEVEL", "0"}});
    EXPECT_EQ(never.outcome.err, "");
    EXPECT_THAT(never.file, HasSubstr("message 5"));
}

TEST(LogFile, NegativeLevelDisablesEverything) {
    const Probe p(Environment{{"ORO_LOGLEVEL", "-1"}});
    EXPECT_EQ(p.outcome.err, "");
    EXPECT_TRUE(p.exists("orocos.log"));
    EXPECT_EQ(p.file, "");
}

TEST(LogFile, BadLevelIsAnError) {
    const Probe p(Environment{{"ORO_LOGLEVEL", "much"}});
    EXPECT_THAT(p.outcome.err,
                HasSubstr("[ ERROR  ][Logger] environment variable ORO_LOGLEVEL is 'much', expected a number"));
    EXPECT_THAT(p.outcome.err, HasSubstr("message 4"));
}

TEST(LogFile, EmptyVariablesAreNone) {
    const Probe p;
    EXPECT_THAT(p.outcome.err, Not(HasSubstr("Logger")));
    EXPECT_THAT(p.file, HasSubstr("message 5"));
}

TEST(LogFile, NameComesFromTheEnvironment) {
    const Probe p(Environment{{"ORO_LOGFILE", "other.log"}});
    EXPECT_FALSE(p.exists("orocos.log"));
    EXPECT_THAT(p.read("other.log"), HasSubstr("message 5"));
    const Probe nowhere(Environment{{"ORO_LOGFILE", "no/such/folder.log"}});
    EXPECT_EQ(nowhere.outcome.status, 0);
    EXPECT_THAT(nowhere.outcome.err, HasSubstr("message 4"));
    EXPECT_THAT(nowhere.outcome.err,
                HasSubstr("[ Warning][Logger] no log file: 'no/such/folder.log' cannot be written: No such "
                          "file or directory"));
}

TEST(LogFile, RealTimeLevelSilencesUnlessAllowed) {
    const Probe silent(Environment{}, {"--realtime"});
    EXPECT_EQ(silent.outcome.err, "");
    EXPECT_THAT(silent.file, Not(HasSubstr("message")));
    const Probe allowed(Environment{}, {"--allow", "--realtime"});
    EXPECT_THAT(allowed.outcome.err, HasSubstr("[RealTime][probe] message 7"));
    const Probe never(Environment{}, {"--never"});
    EXPECT_EQ(never.outcome.err, "");
    EXPECT_THAT(never.file, HasSubstr("message 5"));
}

TEST(LogFile, SecondStartKeepsWhatTheFirstLogged) {
    const Probe p(Environment{}, {"--restart"});
    EXPECT_THAT(p.file, HasSubstr("first session"));
    EXPECT_THAT(p.file, HasSubstr("message 5"));
    EXPECT_THAT(p.outcome.err, Not(HasSubstr("between")));
}
