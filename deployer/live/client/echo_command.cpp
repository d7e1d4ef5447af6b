// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// oro echo
#include "follow.hpp"

#include "failure.hpp"
#include "value_text.hpp"

#include <cstdio>

namespace oroforge::live_client {
namespace {

/** A cell of a CSV file (RFC 4180). */
std::string csvCell(const std::string& text) {
    if (text.find_first_of("\",\n\r") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

/** Seconds since 1970, with nine digits behind the point. */
std::string secondsOf(long long nanoseconds) {
    constexpr long long kSecond = 1000000000;
    char text[40];
    std::snprintf(text, sizeof text, "%lld.%09lld", nanoseconds / kSecond, nanoseconds % kSecond);
    return text;
}

/** A file gets texts as they are; a terminal would obey control characters in them. */
std::string rowOf(const Json& message, const Json& value, bool forTerminal) {
    std::string row = secondsOf(wholeOf(message, "time"));
    for (const auto& leaf : leavesOf(value)) {
        const std::string text = plainText(leaf.second);
        row += "," + csvCell(forTerminal ? printable(text) : text);
    }
    return row;
}

std::string headerOf(const Json& value) {
    std::string row = "time";
    for (const auto& leaf : leavesOf(value)) row += "," + csvCell(leaf.first.empty() ? "value" : leaf.first);
    return row;
}

class Lines {
public:
    explicit Lines(Session& session) : out_(session.out()), csv_(session.given().has("csv")), json_(session.json()) {
        if (csv_ && json_)
            throw Failure(Status::Usage, "--csv and --json exclude each other: both say how samples are written");
    }
    void add(const Json& message, const Json& value) {
        if (json_) {
            out_.line(lineOf({{"time", memberOf(message, "time")}, {"value", value}, {"dropped", dropped(message)}}));
            return;
        }
        if (const long long lost = dropped(message) - dropped_; lost > 0)
            remark(std::to_string(lost) + (lost == 1 ? " sample was" : " samples were") +
                   " dropped here; they come faster than they are taken");
        dropped_ = dropped(message);
        if (!csv_) return out_.line(valueText(value));
        const std::string header = headerOf(value);
        // A sequence that has another length has other columns.
        if (header != header_) out_.line(header_ = header);
        out_.line(rowOf(message, value, out_.isTerminal()));
    }

private:
    static long long dropped(const Json& message) { return wholeOf(message, "dropped"); }

    Output& out_;
    const bool csv_, json_;
    std::string header_;
    long long dropped_ = 0;  // until the last sample
};

}  // namespace

void echoPort(Session& session) {
    constexpr double kMost = 1e15;
    const Given& given = session.given();
    if (given.has("once") && given.has("count"))
        throw Failure(Status::Usage, "--once and --count exclude each other: --once is --count 1");
    double left = given.has("once") ? 1 : given.number("count", 0, 1, kMost);
    const bool counts = left > 0;
    Json fields = Json::object();
    if (given.has("rate")) fields["rate"] = given.number("rate", 0, 0.001, 1000);
    Lines lines(session);
    followPort(session, fields, [&](const Json& message, const Json& value) {
        lines.add(message, value);
        return !counts || --left > 0;
    });
}

}  // namespace oroforge::live_client
