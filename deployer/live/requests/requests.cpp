// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "requests.hpp"

#include "fields.hpp"
#include "ticket.hpp"
#include "verbs.hpp"
#include "workers.hpp"

#include <diag/nearest_match.hpp>
#include <rtt/ExecutionEngine.hpp>
#include <rtt/rtt-config.h>

#include <chrono>
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
    const char* option;   ///< what allows it
    double seconds;       ///< the usual time limit
    bool needsPath;
};

const std::map<std::string, Verb>& verbs() {
    static const std::map<std::string, Verb> all = {
        {"tree", {&tree, nullptr, "", 1, false}},
        {"show", {&show, nullptr, "", 1, false}},
        {"get", {&get, nullptr, "", 1, true}},
    };
    return all;
}

std::string userName() {
    const passwd* const entry = getpwuid(geteuid());
    return entry ? entry->pw_name : std::to_string(geteuid());
}

std::int64_t nowSince1970() {
    using namespace std::chrono;
    return duration_cast<nanoseconds>(system_clock::now().time_since_epoch()).count();
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
    const std::int64_t started = nowSince1970();
    Workers workers;
    std::map<std::string, std::shared_ptr<Outlet>> outlets;

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
        return {{"name", about.name}, {"pid", getpid()},    {"version", about.version}, {"target", OROCOS_TARGET_NAME},
                {"user", user},       {"started", started}, {"files", about.files},     {"allow", std::move(allow)}};
    }

    void dispatch(const std::shared_ptr<Ticket>& ticket);
};

Requests::Requests(RTT::TaskContext& deployer, Deployment about, std::function<void()> stop)
    : state_(std::make_shared<State>(deployer, std::move(about), std::move(stop))) {}

Requests::~Requests() {
    for (const auto& [caller, outlet] : state_->outlets) outlet->close();
}

void Requests::left(const std::string& caller) {
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

void Requests::State::dispatch(const std::shared_ptr<Ticket>& ticket) {
    const json& request = ticket->request();
    const Rights& rights = ticket->caller().rights;
    if (!request.is_object())
        throw Failure(kMalformed, std::string("the request is ") + kindOf(request) + ", expected an object");
    const std::string op = textField(request, "op"), prefix = "oro.";
    const std::string name = op.compare(0, prefix.size(), prefix) == 0 ? op.substr(prefix.size()) : "";
    if (name == "hello") return ticket->answer(hello(rights));
    const auto found = verbs().find(name);
    if (found == verbs().end()) {
        std::vector<std::string> known{"hello"};
        for (const auto& [each, verb] : verbs()) known.push_back(each);
        throw Failure(kUnknownVerb, "there is no verb '" + op + "'" + oroforge::diag::didYouMean(name, known));
    }
    const Verb& verb = found->second;
    if (verb.right && !(rights.*verb.right))
        throw Failure(kNotAllowed,
                      "'" + op + "' is not allowed here; the deployer's option " + verb.option + " allows it");
    if (verb.needsPath) (void)textField(request, "path");
    const double seconds = secondsField(request, "timeout", verb.seconds);
    const auto run = [from = root, ticket, function = verb.function](std::int64_t deadline) {
        return function({from, ticket->request(), ticket->caller(), deadline});
    };
    workers.add({ticket, run, deadlineIn(seconds), "'" + op + "' was not done within " + secondsText(seconds)});
}

}  // namespace OCL::live
