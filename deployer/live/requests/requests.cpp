// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "requests.hpp"

#include "consoles.hpp"
#include "fields.hpp"
#include "ticket.hpp"
#include "verbs.hpp"
#include "workers.hpp"

#include <diag/nearest_match.hpp>
#include <rtt/ExecutionEngine.hpp>
#include <rtt/Logger.hpp>
#include <rtt/internal/log_file_name.hpp>
#include <rtt/rtt-config.h>

#include <map>
#include <utility>

#include <pwd.h>
#include <unistd.h>

namespace OCL::live {
namespace {

using nlohmann::json;

typedef json (*Function)(const Asked&);

struct Verb {
    Function function;
    bool Rights::*right;  ///< null: looking is always allowed
    double seconds;       ///< the usual time limit
    bool needsPath;
};

const std::map<std::string, Verb>& verbs() {
    static const std::map<std::string, Verb> all = {
        {"tree", {&tree, nullptr, 1, false}},
        {"show", {&show, nullptr, 1, false}},
        {"get", {&get, nullptr, 1, true}},
        {"set", {&set, &Rights::properties, 1, true}},
        {"call", {&call, &Rights::operations, 1, true}},
        {"lifecycle", {&lifecycle, &Rights::lifecycle, 10, false}},
        {"describe", {&describe, nullptr, 1, false}},
        {"graph", {&graph, nullptr, 1, false}},
        {"lines", {&lines, nullptr, 1, false}},
        {"ports", {&ports, nullptr, 1, false}},
        {"top", {&top, nullptr, 15, false}},
    };
    return all;
}

/** The word of the deployer's option that allows it. */
const char* wordOf(bool Rights::*right) {
    if (right == &Rights::properties) return "properties";
    if (right == &Rights::operations) return "operations";
    return "lifecycle";
}

[[noreturn]] void refuse(const std::string& op, const char* option) {
    throw Failure(kNotAllowed,
                  "'" + op + "' is not allowed here; the deployer's option --web-allow=" + option + " allows it");
}

[[noreturn]] void refuseRemote(const std::string& op) {
    throw Failure(kNotAllowed,
                  "'" + op + "' is not allowed here; only 'oro' on the same computer, without --url, may do it");
}

std::string userName() {
    const passwd* const entry = getpwuid(geteuid());
    return entry ? entry->pw_name : std::to_string(geteuid());
}

}  // namespace

struct Requests::State {
    State(RTT::TaskContext& deployer, Deployment deployment, std::function<void()> stopIt)
        : root{deployer.engine()->gate(), deployer.getName()},
          about(std::move(deployment)),
          stop(std::move(stopIt)),
          user(userName()) {}

    const Root root;
    const Deployment about;
    const std::function<void()> stop;
    const std::string user;
    Workers workers;
    std::map<std::string, std::shared_ptr<Outlet>> outlets;
    Consoles consoles{root};

    std::shared_ptr<Outlet> outletOf(const std::string& caller) {
        std::shared_ptr<Outlet>& outlet = outlets[caller];
        if (!outlet) outlet = std::make_shared<Outlet>();
        return outlet;
    }

    json hello(const Rights& rights) const {
        json allow = json::array();
        if (rights.properties) allow.push_back("properties");
        if (rights.operations) allow.push_back("operations");
        if (rights.lifecycle) allow.push_back("lifecycle");
        if (rights.stop) allow.push_back("stop");
        if (rights.console) allow.push_back("console");
        return {{"name", about.name},
                {"pid", getpid()},
                {"version", about.version},
                {"target", OROCOS_TARGET_NAME},
                {"user", user},
                {"started", about.started},
                {"files", about.files},
                {"allow", std::move(allow)},
                {"log", RTT::internal::flushedLogFile()}};
    }

    /** True if it was one of the verbs that this thread executes. */
    bool isDoneHere(const std::string& verb, const std::shared_ptr<Ticket>& ticket);
    void dispatch(const std::shared_ptr<Ticket>& ticket);
};

Requests::Requests(RTT::TaskContext& deployer, Deployment about, std::function<void()> stop)
    : state_(std::make_shared<State>(deployer, std::move(about), std::move(stop))) {}

Requests::~Requests() {
    for (const auto& [caller, outlet] : state_->outlets) outlet->close();
}

void Requests::left(const std::string& caller) {
    state_->consoles.left(caller);
    const auto outlet = state_->outlets.find(caller);
    if (outlet == state_->outlets.end()) return;
    outlet->second->close();
    state_->outlets.erase(outlet);
}

void Requests::handle(const json& request, const Caller& caller, Answer answer) {
    const bool tooDeep = isTooDeep(request);
    // A copy of a deep one would overflow the stack.
    const auto ticket =
        std::make_shared<Ticket>(state_->outletOf(caller.name), tooDeep ? json() : request, caller, std::move(answer));
    try {
        if (tooDeep) throw Failure(kMalformed, "the request nests too deeply");
        state_->dispatch(ticket);
    } catch (const Failure& failure) {
        ticket->fail(failure.code(), failure.what());
    } catch (const std::exception& thrown) {
        ticket->fail(kFailed, thrown.what());
    }
}

bool Requests::State::isDoneHere(const std::string& verb, const std::shared_ptr<Ticket>& ticket) {
    typedef void (Consoles::*OfConsole)(const std::shared_ptr<Ticket>&);
    static const std::map<std::string, OfConsole> ofConsole = {
        {"line", &Consoles::line}, {"complete", &Consoles::complete}, {"interrupt", &Consoles::interrupt}};
    const Rights& rights = ticket->caller().rights;
    if (verb == "hello") return ticket->answer(hello(rights)), true;
    if (verb == "stop") {
        if (!rights.stop) refuseRemote("oro.stop");
        RTT::log(RTT::Info) << ticket->caller().name << " stops the deployment" << RTT::endlog();
        ticket->answer({{"done", true}});
        if (stop) stop();
        return true;
    }
    const auto found = ofConsole.find(verb);
    if (found == ofConsole.end()) return false;
    if (!rights.console) refuseRemote("oro." + verb);
    (consoles.*found->second)(ticket);
    return true;
}

void Requests::State::dispatch(const std::shared_ptr<Ticket>& ticket) {
    const json& request = ticket->request();
    const Rights& rights = ticket->caller().rights;
    if (!request.is_object())
        throw Failure(kMalformed, std::string("the request is ") + kindOf(request) + ", expected an object");
    const std::string op = textField(request, "op"), prefix = "oro.";
    const std::string name = op.compare(0, prefix.size(), prefix) == 0 ? op.substr(prefix.size()) : "";
    if (isDoneHere(name, ticket)) return;
    const auto found = verbs().find(name);
    if (found == verbs().end()) {
        std::vector<std::string> known{"hello", "stop", "line", "complete", "interrupt"};
        for (const auto& [each, verb] : verbs()) known.push_back(each);
        throw Failure(kUnknownVerb, "there is no verb '" + op + "'" + oroforge::diag::didYouMean(name, known));
    }
    const Verb& verb = found->second;
    if (verb.right && !(rights.*verb.right)) refuse(op, wordOf(verb.right));
    if (verb.needsPath) (void)textField(request, "path");
    const double seconds = secondsField(request, "timeout", verb.seconds);
    const auto run = [from = root, ticket, seconds, function = verb.function](std::int64_t deadline) {
        return function({from, ticket->request(), ticket->caller(), {deadline, seconds}});
    };
    workers.add({ticket, run, deadlineIn(seconds), "'" + op + "' was not done within " + secondsText(seconds)});
}

}  // namespace OCL::live
