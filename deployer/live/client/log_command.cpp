// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// oro log
#include "follow.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <ctime>

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

}  // namespace

void showLog(Session& session) {
    double left = session.given().number("count", 0, 1, 1e15);
    const bool counts = left > 0;
    Json fields = {{"follow", true}};
    const std::string level = session.given().text("level");
    if (!level.empty()) fields["level"] = level;
    const auto each = [&](const Json& message) {
        writeLine(session, message);
        return !counts || --left > 0;
    };
    follow(session, "log", fields, "oro.line", {each});
}

}  // namespace oroforge::live_client
