// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// oro top
#include "session.hpp"

#include "failure.hpp"
#include "interrupts.hpp"
#include "picture.hpp"
#include "state_text.hpp"

#include <cmath>
#include <cstdio>
#include <sstream>

namespace oroforge::live_client {
namespace {

/** Seconds as text: "1.5 ms"; empty for a value that there is not. */
std::string duration(const Json& seconds) {
    if (!seconds.is_number()) return "";
    const double value = seconds.get<double>(), size = std::fabs(value);
    char text[40];
    if (size >= 1 || size == 0)
        std::snprintf(text, sizeof text, "%.4g s", value);
    else if (size >= 1e-3)
        std::snprintf(text, sizeof text, "%.4g ms", value * 1e3);
    else
        std::snprintf(text, sizeof text, "%.3g us", value * 1e6);
    return text;
}

/** The mean and the greatest one. */
std::string durations(const Json& component) {
    const std::string mean = duration(memberOf(component, "duration")), most = duration(memberOf(component, "longest"));
    return most.empty() ? mean : mean + " / " + most;
}

/** "RT", "OTHER" */
std::string schedulerOf(const Json& component) {
    const std::string name = printable(textOf(component, "scheduler")), prefix = "ORO_SCHED_";
    return name.compare(0, prefix.size(), prefix) == 0 ? name.substr(prefix.size()) : name;
}

std::string percent(const Json& share) {
    if (!share.is_number()) return "";
    char text[32];
    std::snprintf(text, sizeof text, "%.1f %%", share.get<double>() * 100);
    return text;
}

std::string cell(const Json& object, const char* name) { return printable(textOf(object, name)); }

Table tableOf(const Json& top) {
    Table table({Style::Name, Style::Plain, Style::Plain, Style::Plain, Style::Plain, Style::Plain, Style::Plain,
                 Style::Plain, Style::Plain});
    table.add({"COMPONENT", "STATE", "PERIOD", "DURATION", "LATENESS", "CPU", "SCHEDULER", "PRIORITY", "OVERRUNS"});
    for (const Json& one : memberOf(top, "components"))
        table.add({cell(one, "name"), cell(one, "state"), duration(memberOf(one, "period")), durations(one),
                   duration(memberOf(one, "lateness")), percent(memberOf(one, "cpu")), schedulerOf(one),
                   cell(one, "priority"), cell(one, "overruns")});
    return table;
}

std::vector<std::string> linesOf(Output& out, const Table& table) {
    std::ostringstream text;
    table.write(text, out.theme(), "", out.tableWidth());
    std::vector<std::string> lines;
    std::istringstream in(text.str());
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

}  // namespace

void showTop(Session& session) {
    Requests& deployment = session.deployment();
    const double seconds = session.given().number("interval", 1, 0.1, 10);
    const auto interval = std::chrono::milliseconds(std::llround(seconds * 1000));
    // The deployment measures for so long.
    const auto measure = [&] { return deployment.ask("top", {{"seconds", seconds}}, interval + deployment.limit()); };
    if (session.given().has("once") || session.json() || !session.out().isTerminal()) {
        const Json top = measure();
        if (!session.answeredAsJson(top)) session.out().table(tableOf(top));
        return;
    }
    Interrupts interrupts;
    deployment.connection().wakeOn({interrupts.descriptor()});
    Picture picture(session.out());
    const std::string title = printable(deployment.name()) + "  " + session.out().paint(Style::Faint, "Ctrl-C ends");
    picture.draw({title});
    try {
        for (;;) {
            std::vector<std::string> lines = linesOf(session.out(), tableOf(measure()));
            lines.insert(lines.begin(), title);
            picture.draw(lines);
        }
    } catch (const Interrupted&) {
    }
}

}  // namespace oroforge::live_client
