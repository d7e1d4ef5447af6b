// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Time and colours of lines.
#include "log_probe_run.hpp"

#include <rtt/detail/log_clock.hpp>

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <gmock/gmock.h>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace os_test;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

namespace {

std::string wallTime(std::int64_t seconds, int offset, std::int64_t ns = 0) {
    char out[RTT::detail::kLongestWallTime];
    return {out, RTT::detail::formatWallTime(out, seconds * 1000000000 + ns, offset)};
}

TEST(LogTime, DatesAreThoseOfTheCalendar) {
    EXPECT_EQ(wallTime(0, 0), "1970-01-01T00:00:00.000+00:00");
    EXPECT_EQ(wallTime(951782399, 0, 999999999), "2000-02-28T23:59:59.999+00:00");
    EXPECT_EQ(wallTime(951782400, -12600), "2000-02-28T20:30:00.000-03:30");
    EXPECT_EQ(wallTime(-1, 0, 1), "1969-12-31T23:59:59.000+00:00");
    EXPECT_EQ(wallTime(4107542400, 20700), "2100-03-01T05:45:00.000+05:45");
    for (std::int64_t day = -80000; day < 90000; day += 13) {
        const std::time_t moment = day * 86400 + day;
        std::tm utc{};
        gmtime_r(&moment, &utc);
        char expected[40];
        std::strftime(expected, sizeof expected, "%Y-%m-%dT%H:%M:%S.000+00:00", &utc);
        ASSERT_EQ(wallTime(moment, 0), expected);
    }
}

TEST(LogTime, IsThatOfTheWallOnRequest) {
    const std::time_t before = std::time(nullptr);
    for (const auto& zone : {std::make_pair("AAA-5:45", "+05:45"), std::make_pair("BBB+3:30", "-03:30")}) {
        for (const bool byProgram : {false, true}) {
            Environment environment{{"TZ", zone.first}};
            if (!byProgram) environment["ORO_LOGTIME"] = "wall";
            const Probe p(environment, byProgram ? std::vector<std::string>{"--wall"} : std::vector<std::string>{});
            const std::string end = std::string(zone.second) + " [ Warning][probe] message 4\n";
            for (const std::string& text : {p.file, p.outcome.err}) {
                ASSERT_THAT(text, HasSubstr(end));
                const std::size_t at = text.find(end) - 23;
                std::tm local{};
                ASSERT_NE(strptime(text.c_str() + at, "%Y-%m-%dT%H:%M:%S", &local), nullptr) << text;
                const std::time_t shown = timegm(&local) - (zone.second[0] == '+' ? 20700 : -12600);
                EXPECT_NEAR(static_cast<double>(shown), static_cast<double>(before), 120);
            }
            EXPECT_THAT(p.file, HasSubstr("times in this log are local time"));
            EXPECT_THAT(p.file, Not(ContainsRegex("(^|\n)[0-9]+\\.[0-9]"))) << "also of the first lines";
        }
    }
}

TEST(LogTime, IsRelativeOtherwise) {
    for (const char* value : {"", "relative"}) {
        const Probe p(Environment{{"ORO_LOGTIME", value}});
        EXPECT_THAT(p.file, ContainsRegex("\n[0-9]+\\.[0-9][0-9][0-9] \\[ Info   \\]\\[probe\\] message 5\n"));
        EXPECT_THAT(p.outcome.err, Not(HasSubstr("ORO_LOGTIME")));
    }
    const Probe wrong(Environment{{"ORO_LOGTIME", "clock"}});
    EXPECT_THAT(wrong.outcome.err, ContainsRegex("^[0-9]+\\.[0-9]+ \\[ Warning\\]\\[Logger\\] environment variable "
                                                 "ORO_LOGTIME is 'clock', expected 'relative' or 'wall'"));
}

/** What log_probe writes to the terminal of its standard error stream. */
std::string atTerminal(Environment environment, std::vector<std::string> arguments, Probe& probe) {
    const int controller = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    EXPECT_TRUE(controller >= 0 && grantpt(controller) == 0 && unlockpt(controller) == 0);
    environment.emplace("NO_COLOR", "");
    environment.emplace("TERM", "xterm");
    oroforge::test::Command command =
        probeCommand(probe.directory.path(), std::move(environment), std::move(arguments));
    std::string words;
    for (const std::string& word : command.arguments) words += " " + word;
    command.arguments = {"-c", "exec " + command.program + words + " 2> " + ptsname(controller)};
    command.program = "sh";
    const int held = open(ptsname(controller), O_RDWR | O_NOCTTY | O_CLOEXEC);
    probe.outcome = oroforge::test::run(command);
    probe.file = probe.read("orocos.log");
    fcntl(controller, F_SETFL, O_NONBLOCK);
    std::string text;
    char part[4096];
    for (ssize_t size = 0; (size = read(controller, part, sizeof part)) > 0;)
        text.append(part, static_cast<std::size_t>(size));
    close(held);
    close(controller);
    return text;
}
std::string atTerminal(Environment environment, std::vector<std::string> arguments = {}) {
    Probe probe;
    return atTerminal(std::move(environment), std::move(arguments), probe);
}

constexpr const char* kRedError = "\033[1;31m[ ERROR  ]\033[0m[probe] message 3\r\n";

TEST(LogColors, LevelsHaveThemOnATerminal) {
    Probe probe;
    const std::string text = atTerminal({{"ORO_LOGLEVEL", "6"}}, {}, probe);
    EXPECT_THAT(text, HasSubstr(kRedError));
    EXPECT_THAT(text, HasSubstr("\033[33m[ Warning]\033[0m[probe] message 4\r\n"));
    EXPECT_THAT(text, HasSubstr("\033[36m[ Debug  ]\033[0m[probe] message 6\r\n"));
    EXPECT_EQ(count(text, "\033["), 2 * count(text, "\r\n")) << "each line begins and ends one";
    EXPECT_THAT(probe.file, HasSubstr(" [ ERROR  ][probe] message 3\n"));
    EXPECT_THAT(probe.file, Not(HasSubstr("\033")));
}

TEST(LogColors, NobodyElseGetsThem) {
    EXPECT_THAT(Probe(Environment{{"TERM", "xterm"}, {"NO_COLOR", ""}}).outcome.err, Not(HasSubstr("\033")));
    for (const auto& no : {std::make_pair("NO_COLOR", "1"), std::make_pair("TERM", "dumb"), std::make_pair("TERM", ""),
                           std::make_pair("ORO_LOGCOLOR", "never")})
        EXPECT_THAT(atTerminal({{no.first, no.second}}), Not(HasSubstr("\033"))) << no.first;
    EXPECT_THAT(atTerminal({{"ORO_LOGCOLOR", "auto"}}), HasSubstr(kRedError));
}

TEST(LogColors, AreForcedOnRequest) {
    const Probe probe(Environment{{"ORO_LOGCOLOR", "always"}, {"NO_COLOR", "1"}, {"TERM", "dumb"}});
    EXPECT_THAT(probe.outcome.err, HasSubstr("\033[1;31m[ ERROR  ]\033[0m[probe] message 3\n"));
    EXPECT_THAT(probe.file, Not(HasSubstr("\033")));
    EXPECT_THAT(Probe(Environment{{"ORO_LOGCOLOR", "red"}}).outcome.err,
                HasSubstr("environment variable ORO_LOGCOLOR is 'red', expected 'auto', 'never' or 'always'"));
}

TEST(LogColors, ABufferOfUsersGetsNone) {
    Probe probe;
    const std::string text = atTerminal({}, {"--buffer"}, probe);
    EXPECT_THAT(probe.outcome.out, HasSubstr("[ ERROR  ][main] in a window\n"));
    EXPECT_THAT(probe.outcome.out, Not(HasSubstr("\033")));
    EXPECT_THAT(text, HasSubstr(kRedError)) << "afterwards";
}

}  // namespace
