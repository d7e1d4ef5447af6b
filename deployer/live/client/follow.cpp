// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "follow.hpp"

#include "failure.hpp"
#include "interrupts.hpp"
#include "value_text.hpp"

#include <diag/nearest_match.hpp>

#include <algorithm>
#include <exception>
#include <utility>

namespace oroforge::live_client {
namespace {

std::vector<std::string> fieldNames(const Json& value) {
    std::vector<std::string> names;
    for (const auto& leaf : leavesOf(value)) names.push_back(leaf.first);
    return names;
}

[[noreturn]] void reportField(const PortPath& path, const Json& value) {
    const auto names = fieldNames(value);
    std::string text =
        "samples of port '" + path.port + "' have no field '" + path.field + "'" + diag::didYouMean(path.field, names);
    constexpr std::size_t kMostNamed = 8;
    if (names.size() > 1) text += "; they have ";
    for (std::size_t i = 0; names.size() > 1 && i != std::min(names.size(), kMostNamed); ++i)
        text += (i ? ", " : "") + names[i];
    throw Failure(Status::Refused, text + (names.size() > kMostNamed ? " and others" : ""));
}

}  // namespace

void follow(Session& session, const std::string& verb, const Json& fields, const std::string& op,
            const Follower& follower) {
    Requests& deployment = session.deployment();
    Interrupts interrupts;
    deployment.connection().wakeOn({interrupts.descriptor()});
    deployment.connection().endOn(session.out().descriptor());
    long long id = 0;
    try {
        id = deployment.send(verb, fields);
        const Deadline answered = deadlineIn(deployment.limit());
        bool begun = false;
        Deadline next = follower.tick ? Clock::now() + follower.interval : kNever;
        for (Json message;;) {
            const auto event = deployment.next(message, begun ? next : std::min(next, answered));
            if (event == Requests::Event::Woken) return;
            if (follower.tick && Clock::now() >= next) {
                next = std::max(next + follower.interval, Clock::now());
                if (!follower.tick()) return;
            }
            if (event == Requests::Event::Time && !begun && Clock::now() >= answered)
                deployment.reportSilence(deployment.limit());
            if (event != Requests::Event::Message) continue;
            if (Requests::answers(message, id)) {
                Requests::resultOf(message);
                begun = true;
                if (follower.begin) follower.begin();
            } else if (textOf(message, "op") == op && wholeOf(message, "id", -1) == id && !follower.each(message)) {
                return;
            }
        }
    } catch (const Interrupted&) {
    }
}

PortPath findPort(Session& session, const std::string& path) {
    const std::string whole = path.substr(0, path.find('['));
    std::exception_ptr first;  // about the whole path
    for (std::string port = whole;; port.erase(port.rfind('.'))) {
        try {
            const Json found = session.deployment().ask("show", {{"path", port}});
            // A field of a sample has no connections.
            if (textOf(found, "kind") == "port" && memberOf(found, "connections").is_array()) {
                const bool more = port.size() < path.size() && path[port.size()] == '.';
                return {port, path.substr(port.size() + (more ? 1 : 0))};
            }
            if (textOf(found, "kind") != "port")
                throw Failure(Status::Refused, "'" + port + "' is no port; 'oro show " +
                                                   port.substr(0, port.find('.')) + "' lists the ports");
        } catch (const Refusal&) {
            if (!first) first = std::current_exception();
        }
        // What is behind the port is a field of its type.
        const std::size_t dot = port.rfind('.');
        if (dot == std::string::npos || port.find('.') == dot) break;
    }
    if (first) std::rethrow_exception(first);
    throw Failure(Status::Refused,
                  "'" + path + "' is no port; write COMPONENT.PORT, as 'oro tree' and 'oro show' list them");
}

void followPort(Session& session, const Json& given, const std::function<bool(const Json&, const Json&)>& each,
                const std::function<bool()>& tick, std::chrono::milliseconds interval) {
    PortPath path = findPort(session, session.word(0));
    const std::string field = session.given().text("field");
    if (!field.empty()) path.field += (path.field.empty() ? "" : ".") + field;
    Json fields = {{"port", path.port}, {"format", "json"}};
    for (const auto& other : given.items()) fields[other.key()] = other.value();
    bool isTold = false;
    const auto onSample = [&](const Json& message) {
        const Json& value = memberOf(message, "value");
        const Json* const part = memberAt(value, path.field);
        if (!part && lacksElement(value, path.field)) {
            if (!std::exchange(isTold, true))
                remark("samples without '" + path.field + "', whose sequence is shorter, are left out");
            return true;
        }
        if (!part) reportField(path, value);
        return each(message, *part);
    };
    follow(session, "watch", fields, "oro.sample", {onSample, tick, interval});
}

}  // namespace oroforge::live_client
