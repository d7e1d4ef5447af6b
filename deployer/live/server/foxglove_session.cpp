// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "foxglove_session.hpp"

#include "../requests/failure.hpp"
#include "../samples/wall_time.hpp"
#include "foxglove_service.hpp"
#include "foxglove_text.hpp"
#include "live_client.hpp"
#include "oro_messages.hpp"
#include "text_depth.hpp"

#include <algorithm>
#include <functional>
#include <utility>

namespace OCL::live {
namespace {

using nlohmann::json;

constexpr std::int64_t kPoll = 1000000000, kTimes = 100000000, kTimeStep = 1000000, kClockJump = 1000000000;  // ns
constexpr unsigned kPollPeriod = 250, kBuffer = 128, kMostAtOnce = 2000;
constexpr std::size_t kMostSubscriptions = 1024, kMostWaiting = 16;

std::vector<json> listOf(const json& message, const char* name) {
    const auto found = message.find(name);
    return found == message.end() || !found->is_array() ? std::vector<json>() : found->get<std::vector<json>>();
}

std::uint32_t numberOf(const json& from, const char* name) {
    const auto found = from.is_object() ? from.find(name) : from.end();
    const bool good = from.is_object() && found != from.end() && found->is_number_unsigned() && *found <= UINT32_MAX;
    return good ? found->get<std::uint32_t>() : 0;
}

std::set<std::string> namesOf(const json& message) {
    std::set<std::string> names;
    for (const json& name : listOf(message, "parameterNames"))
        if (name.is_string()) names.insert(name.get<std::string>());
    return names;
}

}  // namespace

FoxgloveSession::FoxgloveSession(LiveClient& client) : client_(client), model_(client) {
    client_.sendText(foxgloveServerInfo("Oroforge", std::to_string(wallTime()), client.caller().rights.operations));
    // Before any channel: Foxglove takes the time that it knows at the first one for the start of the data.
    client_.queue().addAnswer({foxgloveTime(static_cast<std::uint64_t>(wallTime())), true});
    client_.sendText(textOf({{"op", "advertise"}, {"channels", {foxgloveLogChannel()}}}));
}

void FoxgloveSession::warn(const std::string& text) { client_.sendText(foxgloveStatus(2, text)); }

void FoxgloveSession::receive(const json& message, const std::string& op) {
    if (op == "subscribe") return subscribe(message);
    if (op == "unsubscribe") return unsubscribe(message);
    if (op == "getParameters") return getParameters(message);
    if (op == "setParameters") return setParameters(message);
    if (op == "subscribeParameterUpdates") return followed_.merge(namesOf(message));
    if (op == "unsubscribeParameterUpdates") {
        for (const std::string& name : namesOf(message)) followed_.erase(name), lastValues_.erase(name);
        return;
    }
    if (op == "subscribeConnectionGraph" || op == "unsubscribeConnectionGraph") {
        wantsGraph_ = op[0] == 's';
        graph_.forget();
        return;
    }
    warn("'" + op + "' is not offered; ports are not written, and there are no files");
}

void FoxgloveSession::subscribe(const json& message) {
    for (const json& wanted : listOf(message, "subscriptions")) {
        const std::uint32_t id = numberOf(wanted, "id"), channel = numberOf(wanted, "channelId");
        const FoxgloveModel::Channel* const found = model_.channel(channel);
        const bool isUsed = subscriptions_.count(id) != 0 || logs_.count(id) != 0;
        if (isUsed || subscriptions_.size() >= kMostSubscriptions) {
            warn("subscription " + std::to_string(id) + " exists already, or there are 1024");
        } else if (channel == kLogChannel) {
            logs_.insert(id);
        } else if (found) {
            Subscription& made = subscriptions_[id];
            made.path = found->path;
            watch(made);
        } else {
            warn("there is no channel " + std::to_string(channel));
        }
    }
    client_.host().wantsChanged();
}

void FoxgloveSession::watch(Subscription& subscription, bool again) {
    try {
        subscription.port =
            client_.host().watch(subscription.path, {SampleForm::Cdr, kBuffer, /*times=*/true, client_.number()});
    } catch (const Failure& failure) {
        if (!again) warn(failure.what());
    }
}

void FoxgloveSession::unsubscribe(const json& message) {
    for (const json& id : listOf(message, "subscriptionIds")) {
        if (!id.is_number_unsigned()) continue;
        const auto number = id.get<std::uint32_t>();
        if (subscriptions_.erase(number) + logs_.erase(number) != 0) client_.queue().forget(number);
    }
    client_.host().wantsChanged();
}

unsigned FoxgloveSession::wantedPeriod() const {
    return std::any_of(subscriptions_.begin(), subscriptions_.end(),
                       [](const auto& one) { return one.second.port != nullptr; })
               ? kWatchPeriod
               : kPollPeriod;
}

void FoxgloveSession::onTick(std::int64_t now) {
    sendSamples(now);
    if (!waiting_.empty() && model_.isKnown())
        for (Use& use : std::exchange(waiting_, {})) collectAll(std::move(use));
    if (now >= nextTime_) sendTime(wallTime(), now);
    // A client that does not read must not collect answers that it has not asked for.
    if (now < nextPoll_ || client_.isFull()) return;
    nextPoll_ = now + kPoll;
    model_.poll();
    for (auto& [id, subscription] : subscriptions_)
        if (!subscription.port) watch(subscription, /*again=*/true);
    if (!followed_.empty()) updateParameters();
    if (wantsGraph_) updateGraph();
}

/** Foxglove shows a sample at the latest time message, so each millisecond of samples has one. */
void FoxgloveSession::sendSamples(std::int64_t now) {
    std::vector<Sample> samples;
    for (auto& [id, subscription] : subscriptions_) readAll(id, subscription, samples);
    std::stable_sort(samples.begin(), samples.end(),
                     [](const Sample& one, const Sample& other) { return one.time < other.time; });
    for (const Sample& sample : samples) {
        if (sample.time >= lastTime_ + kTimeStep) sendTime(sample.time, now);
        const auto time = static_cast<std::uint64_t>(sample.time);
        client_.queue().addSample(sample.subscription, {foxgloveData(sample.subscription, time, sample.value), true});
    }
}

void FoxgloveSession::readAll(std::uint32_t id, Subscription& subscription, std::vector<Sample>& samples) {
    if (!subscription.port) return;
    const bool isConnected = subscription.port->isConnected();
    std::string value;
    for (unsigned i = 0; i != kMostAtOnce && subscription.port->read(value); ++i)
        if (!value.empty()) samples.push_back({subscription.port->time(), id, value});
    // The component may come back.
    if (!isConnected) subscription.port.reset();
}

/** Goes back only with the clock of the computer, because Foxglove then forgets what it has. */
void FoxgloveSession::sendTime(std::int64_t time, std::int64_t now) {
    nextTime_ = now + kTimes;
    if (time <= lastTime_ && time > lastTime_ - kClockJump) return;
    lastTime_ = time;
    client_.queue().addSample(0, {foxgloveTime(static_cast<std::uint64_t>(time)), true});
}

void FoxgloveSession::onLines(const std::vector<LogLine>& lines) {
    for (const std::uint32_t id : logs_)
        for (const LogLine& line : lines)
            client_.queue().addSample(
                id, {foxgloveData(id, static_cast<std::uint64_t>(line.time), foxgloveLogLine(line)), true});
}

/** Parameters that are asked for, one owner after another: a client has a share of the threads only. */
struct FoxgloveSession::Collection {
    std::vector<std::string> owners;  // that are left
    Parameters known;
    Use use;
};

void FoxgloveSession::collectAll(Use use) {
    if (!model_.isKnown() && waiting_.size() < kMostWaiting) return waiting_.push_back(std::move(use));
    collect(std::make_shared<Collection>(Collection{model_.owners(), {}, std::move(use)}));
}

void FoxgloveSession::collect(const std::shared_ptr<Collection>& collection) {
    if (collection->owners.empty()) return collection->use(collection->known);
    const std::string path = collection->owners.back();
    collection->owners.pop_back();
    client_.ask({{"op", "oro.show"}, {"id", 0}, {"path", path}},
                [this, path, collection](LiveClient&, const json& answer) {
                    if (answer.count("result") != 0)
                        for (const json& property : answer["result"].value("properties", json::array())) {
                            const std::string name = path + "." + property.value("name", "");
                            collection->known[name] = foxgloveParameter(name, property);
                        }
                    collect(collection);
                });
}

void FoxgloveSession::getParameters(const json& message) {
    const std::set<std::string> names = namesOf(message);
    const json id = message.value("id", json());
    collectAll([this, names, id](const Parameters& all) {
        json values = json::array();
        for (const auto& [name, value] : all)
            if (names.empty() || names.count(name) != 0) values.push_back(value);
        json answer = {{"op", "parameterValues"}, {"parameters", values}};
        if (id.is_string()) answer["id"] = id;
        client_.sendText(textOf(answer));
    });
}

void FoxgloveSession::setParameters(const json& message) {
    const json id = message.value("id", json());
    for (const json& parameter : listOf(message, "parameters")) {
        const std::string name = parameter.is_object() && parameter.count("name") != 0 && parameter["name"].is_string()
                                     ? parameter["name"].get<std::string>()
                                     : std::string();
        const json value = parameter.is_object() ? parameter.value("value", json()) : json();
        client_.ask(
            {{"op", "oro.set"}, {"id", 0}, {"path", name}, {"value", value}},
            [this, name, id](LiveClient&, const json& answer) {
                if (answer.count("result") == 0) return warn(answer.value("message", "it was not set"));
                json made = {{"op", "parameterValues"}, {"parameters", {foxgloveParameter(name, answer["result"])}}};
                if (id.is_string()) made["id"] = id;
                client_.sendText(textOf(made));
            });
    }
}

void FoxgloveSession::updateParameters() {
    if (std::exchange(isUpdating_, true)) return;
    collectAll([this](const Parameters& all) {
        isUpdating_ = false;
        json changed = json::array();
        for (const std::string& name : followed_) {
            const auto found = all.find(name);
            if (found == all.end() || lastValues_[name] == found->second) continue;
            changed.push_back(lastValues_[name] = found->second);
        }
        if (!changed.empty()) client_.sendText(textOf({{"op", "parameterValues"}, {"parameters", changed}}));
    });
}

void FoxgloveSession::updateGraph() {
    client_.ask({{"op", "oro.graph"}, {"id", 0}}, [this](LiveClient&, const json& answer) {
        if (answer.count("result") == 0) return;
        const json changes = graph_.update(model_, answer["result"].value("connections", json::array()));
        if (!changes.is_null()) client_.sendText(textOf(changes));
    });
}

void FoxgloveSession::receiveBinary(std::string_view message) {
    FoxgloveCall wanted;
    if (!parseFoxgloveCall(message, wanted)) return warn("this binary message is not the call of a service");
    const FoxgloveModel::Service* const service = model_.service(wanted.service);
    const json request = isTooDeep(wanted.payload) ? json() : json::parse(wanted.payload, nullptr, false);
    if (!service) return fail(wanted, "there is no such service");
    if (!request.is_object()) return fail(wanted, "the request is not a JSON object");
    std::string why;
    const json arguments = foxgloveArguments(service->arguments, request, why);
    if (arguments.is_null()) return fail(wanted, service->path + ": " + why);
    client_.ask({{"op", "oro.call"}, {"id", 0}, {"path", service->path}, {"arguments", arguments}, {"timeout", 10}},
                [this, id = wanted.service, call = wanted.call](LiveClient&, const json& answer) {
                    const auto result = answer.find("result");
                    if (result == answer.end()) return fail({id, call, {}, {}}, answer.value("message", "it failed"));
                    client_.sendBinary(foxgloveResponse(id, call, "json", textOf(foxgloveResult(*result))));
                });
}

void FoxgloveSession::fail(const FoxgloveCall& call, const std::string& why) {
    client_.sendText(
        textOf({{"op", "serviceCallFailure"}, {"serviceId", call.service}, {"callId", call.call}, {"message", why}}));
}

}  // namespace OCL::live
