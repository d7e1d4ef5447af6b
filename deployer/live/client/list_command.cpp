// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// oro list
#include "session.hpp"

#include "failure.hpp"
#include "state_text.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <thread>

namespace oroforge::live_client {
namespace {

// A deployment that does not answer must not hold up the list of the others.
constexpr std::chrono::milliseconds kLongestWait{500};

struct Row {
    Deployment deployment;
    Json hello, tree;
    std::string problem;  ///< why it has no answer
    bool gone = false;
};

void ask(Row& row, std::chrono::milliseconds limit) {
    try {
        const auto requests = connectTo(row.deployment, limit);
        row.hello = requests->ask("hello");
        row.tree = requests->ask("tree");
    } catch (const Failure& failure) {
        row.gone = failure.status() == Status::NoDeployment;  // between the look at the folder and now
        row.problem = isStopped(row.deployment.pid) ? "stopped process" : "does not answer";
    } catch (const std::exception& failure) {
        row.problem = failure.what();
    }
}

std::string startOf(const Json& hello) {
    const long long nanoseconds = wholeOf(hello, "started");
    if (nanoseconds <= 0) return "";
    const auto seconds = static_cast<std::time_t>(nanoseconds / 1000000000);
    std::tm local = {};
    char text[64];
    if (!localtime_r(&seconds, &local) || std::strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S", &local) == 0) return "";
    return text;
}

/** Without the deployer, which is one, too. */
Json componentsOf(const Row& row) {
    Json found = Json::array();
    for (const Json& component : memberOf(row.tree, "components"))
        if (textOf(component, "name") != textOf(row.hello, "name")) found.push_back(component);
    return found;
}

Json asJson(const Row& row) {
    Json one = {{"name", row.deployment.name}, {"pid", row.deployment.pid}, {"socket", row.deployment.socket}};
    if (!row.problem.empty()) {
        one["problem"] = row.problem;
        return one;
    }
    for (const char* const field : {"version", "target", "user", "started", "files"})
        if (!memberOf(row.hello, field).is_null()) one[field] = memberOf(row.hello, field);
    one["components"] = Json::array();
    for (const Json& component : componentsOf(row))
        one["components"].push_back({{"name", textOf(component, "name")}, {"state", textOf(component, "state")}});
    return one;
}

std::vector<Row> rowsOf(const std::vector<Deployment>& all, std::chrono::milliseconds limit) {
    std::vector<Row> rows;
    for (const Deployment& one : all) rows.push_back({one, {}, {}, {}, false});
    std::vector<std::thread> askers;
    for (std::size_t i = 1; i < rows.size(); ++i) askers.emplace_back([&rows, i, limit] { ask(rows[i], limit); });
    if (!rows.empty()) ask(rows.front(), limit);
    for (std::thread& asker : askers) asker.join();
    rows.erase(std::remove_if(rows.begin(), rows.end(), [](const Row& row) { return row.gone; }), rows.end());
    return rows;
}

}  // namespace

void listDeployments(Session& session) {
    std::vector<Deployment> all = runningDeployments();
    const std::string wanted = session.given().text("deployment");
    if (wanted.find('/') != std::string::npos) {
        all = {chosenDeployment(wanted)};
    } else if (!wanted.empty()) {
        const auto isOther = [&](const Deployment& one) {
            return one.name != wanted && std::to_string(one.pid) != wanted;
        };
        all.erase(std::remove_if(all.begin(), all.end(), isOther), all.end());
    }
    const auto rows = rowsOf(all, std::min(kLongestWait, timeLimitOf(session.given())));
    if (session.json()) {
        Json answer = Json::array();
        for (const Row& row : rows) answer.push_back(asJson(row));
        return session.out().line(lineOf(answer));
    }
    if (rows.empty())
        return remark(session.given().has("deployment") ? "this deployment is not running"
                                                        : "no deployment of this user is running");
    Table table({Style::Name, Style::Plain, Style::Faint, Style::Plain, Style::Plain});
    table.add({"NAME", "PID", "SINCE", "COMPONENTS", "STATES"});
    for (const Row& row : rows) {
        const bool answers = row.problem.empty();
        const Json components = answers ? componentsOf(row) : Json::array();
        table.add({printable(row.deployment.name), std::to_string(row.deployment.pid), startOf(row.hello),
                   answers ? std::to_string(components.size()) : "", answers ? stateSummary(components) : row.problem});
    }
    session.out().table(table);
}

}  // namespace oroforge::live_client
