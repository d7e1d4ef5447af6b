// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// oro log
#include "follow.hpp"

#include "failure.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <ctime>
#include <set>

namespace oroforge::live_client {
namespace {

/** "14:03:59.123" */
std::string timeOf(long long nanoseconds) {
    const auto seconds = static_cast<std::time_t>(nanoseconds / 1000000000);
    std::tm local = {};
    char clock[16] = {}, text[32];
    if (localtime_r(&seconds, &local)) std::strftime(clock, sizeof clock, "%H:%M:%S", &local);
    std::snprintf(text, sizeof text, "%s.%03d", clock, static_cast<int>(nanoseconds / 1000000 % 1000));
    return text;
}

Style styleOf(std::string level) {
    std::transform(level.begin(), level.end(), level.begin(), [](unsigned char c) { return std::tolower(c); });
    if (level == "fatal" || level == "critical" || level == "error") return Style::Bad;
    if (level == "warning") return Style::Value;
    return level == "debug" ? Style::Faint : Style::Plain;
}

void writeLine(Session& session, const Json& message) {
    Output& out = session.out();
    if (session.json()) return out.line(lineOf(message));
    const std::string level = printable(textOf(message, "level"));
    const std::string padded = level.size() < 8 ? level + std::string(8 - level.size(), ' ') : level;
    const std::string origin = printable(textOf(message, "origin"));
    out.line(out.paint(Style::Faint, timeOf(wholeOf(message, "time"))) + "  " + out.paint(styleOf(level), padded) +
             "  " + (origin.empty() ? "" : out.paint(Style::Name, origin) + "  ") + printable(textOf(message, "text")));
}

/** The same for a line that is followed and one of the file, whose time is less accurate. */
std::string keyOf(const Json& line) {
    constexpr long long kSecond = 1000000000;
    return std::to_string((wholeOf(line, "time") + kSecond / 2) / kSecond) + textOf(line, "origin") + '\n' +
           textOf(line, "text");
}

}  // namespace

void showLog(Session& session) {
    constexpr double kMostLines = 10000, kUsualLines = 20;
    const Given& given = session.given();
    const bool follows = given.has("follow") || given.has("count");
    double left = given.number("count", 0, 1, 1e15);
    const bool counts = left > 0;
    Json fields = Json::object();
    if (given.has("level")) fields["level"] = given.text("level");
    const auto last = static_cast<unsigned>(given.number("lines", follows && counts ? 0 : kUsualLines, 0, kMostLines));
    const auto writeLast = [&] {
        Json wanted = fields;
        wanted["last"] = last;
        const Json found = session.deployment().ask("lines", wanted);
        if (textOf(found, "file").empty() && !follows)
            throw Failure(Status::Refused,
                          "the deployment writes no log file, which has the lines of the past; "
                          "'oro log -f' shows new ones");
        std::multiset<std::string> written;
        for (const Json& line : memberOf(found, "lines")) {
            writeLine(session, line);
            written.insert(keyOf(line));
        }
        return written;
    };
    if (!follows) return static_cast<void>(writeLast());
    fields["follow"] = true;
    // Lines that come between the request and the answer are in both.
    std::multiset<std::string> written;
    const auto each = [&](const Json& message) {
        if (const auto found = written.find(keyOf(message)); found != written.end()) return written.erase(found), true;
        writeLine(session, message);
        return !counts || --left > 0;
    };
    const auto begin = [&] {
        if (last != 0) written = writeLast();
    };
    follow(session, "log", fields, "oro.line", {each, {}, std::chrono::milliseconds(1000), begin});
}

}  // namespace oroforge::live_client
