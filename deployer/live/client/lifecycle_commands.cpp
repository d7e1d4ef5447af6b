// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// oro start, stop, configure, cleanup and recover
#include "session.hpp"

#include "discovery.hpp"
#include "failure.hpp"
#include "state_text.hpp"

#include <thread>

namespace oroforge::live_client {
namespace {

constexpr std::chrono::milliseconds kOfHooks{15000};

void change(Session& session, const char* what) {
    const std::string& component = session.word(0);
    // Hooks may open devices.
    const auto limit = session.given().has("timeout") ? session.deployment().limit() : kOfHooks;
    const Json result = session.deployment().ask("lifecycle", {{"component", component}, {"do", what}}, limit);
    const std::string state = printable(textOf(result, "state"));
    const bool done = truthOf(result, "done");
    if (session.json()) session.out().line(lineOf(result));
    if (!done)
        throw Failure(Status::Refused, "component '" + component + "' refuses to " + what + "; it is " + state +
                                           ". 'oro log' shows what it reported");
    if (!session.json())
        session.out().line(printable(component) + "  " + session.out().paint(styleOfState(state), state));
}

constexpr std::chrono::milliseconds kBetweenLooks{5};

[[noreturn]] void reportDelay(const Requests& deployment) {
    throw Failure(Status::Refused, "deployment '" + deployment.name() +
                                       "' takes longer than --timeout to end, as long as code of a component does not "
                                       "return; it goes on to end");
}

/** Waits for the end of the connection, which is thrown; a Failure if that does not come. */
[[noreturn]] void awaitEnd(Requests& deployment, Deadline deadline) {
    for (Json message; deployment.next(message, deadline) != Requests::Event::Time;) {
    }
    reportDelay(deployment);
}

/** Clients are let go before components are destroyed. */
void awaitProcess(const Requests& deployment, Deadline deadline) {
    if (deployment.pid() == 0) return;
    for (; !hasEnded(deployment.pid()); std::this_thread::sleep_for(kBetweenLooks))
        if (Clock::now() >= deadline) reportDelay(deployment);
}

}  // namespace

void startComponent(Session& session) { change(session, "start"); }
void configureComponent(Session& session) { change(session, "configure"); }
void cleanUpComponent(Session& session) { change(session, "cleanup"); }
void recoverComponent(Session& session) { change(session, "recover"); }

void stopSomething(Session& session) {
    if (!session.word(0).empty()) return change(session, "stop");
    Requests& deployment = session.deployment();
    const Deadline deadline = deadlineIn(deployment.limit());
    Json result = {{"done", true}};
    try {
        result = deployment.ask("stop");
        awaitEnd(deployment, deadline);
    } catch (const Ended&) {
        // Perhaps before its answer was sent.
    }
    awaitProcess(deployment, deadline);
    if (!session.answeredAsJson(result))
        session.out().line("deployment '" + printable(deployment.name()) + "' has ended");
}

}  // namespace oroforge::live_client
