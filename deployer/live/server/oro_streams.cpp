// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "oro_streams.hpp"

#include "../requests/log_levels.hpp"
#include "live_client.hpp"
#include "oro_messages.hpp"

#include <cmath>
#include <utility>

namespace OCL::live {
namespace {

using nlohmann::json;

constexpr std::size_t kMostWatches = 1024, kMostLogs = 256;
/** What may wait for a recorder: half a second of 32 MB/s. */
constexpr std::size_t kQueueOfRecorder = std::size_t(16) << 20;
constexpr unsigned kUsualBuffer = 128, kLargestBuffer = 10000;
/** Of one port at a time, so that a fast one does not keep the others waiting. */
constexpr unsigned kMostAtOnce = 2000;
constexpr double kSecond = 1e9;
/** The number of that name; `otherwise` if there is none. False if it is not between the limits. */
bool parseNumber(const json& message, const char* name, double least, double most, double& number) {
    const auto found = message.find(name);
    if (found == message.end() || found->is_null()) return true;
    if (!found->is_number()) return false;
    number = found->get<double>();
    return number >= least && number <= most;
}

json fieldsOf(RTT::base::DataSourceBase& value) {
    json fields = json::array();
    for (const std::string& name : value.getMemberNames()) {
        const RTT::base::DataSourceBase::shared_ptr member = value.getMember(name);
        fields.push_back({{"name", name}, {"type", member ? member->getTypeName() : "unknown"}});
    }
    return fields;
}

}  // namespace

bool OroStreams::receive(const json& message, const json& id, const std::string& op) {
    if (op == "oro.watch")
        watch(message, id);
    else if (op == "oro.unwatch")
        end(message, id, "watch");
    else if (op == "oro.log")
        log(message, id);
    else if (op == "oro.unlog")
        end(message, id, "log");
    else
        return false;
    return true;
}

void OroStreams::watch(const json& message, const json& id) {
    const auto fail = [&](const char* code, const std::string& text) { client_.sendText(oroError(id, code, text)); };
    Watch made;
    double rate = 0, buffer = kUsualBuffer;
    const auto port = message.find("port");
    const auto form = message.find("format");
    if (port == message.end() || !port->is_string()) return fail(kMalformed, "the text 'port' is missing");
    const bool isBinary = form != message.end() && *form == "cdr";
    if (form != message.end() && !isBinary && *form != "json")
        return fail(kMalformed, "'format' is neither \"json\" nor \"cdr\"");
    if (!parseNumber(message, "rate", 0.001, 1000, rate))
        return fail(kMalformed, "'rate' is not a number of samples per second from 0.001 to 1000");
    if (isBinary && rate > 0) return fail(kMalformed, "a watch with 'rate' has the format \"json\"");
    if (!parseNumber(message, "buffer", 1, kLargestBuffer, buffer))
        return fail(kMalformed, "'buffer' is not a number of samples from 1 to 10000");
    const json times = message.value("times", json(false));
    if (!times.is_boolean()) return fail(kMalformed, "'times' is neither true nor false");
    if (times == true && rate > 0) return fail(kMalformed, "a watch with 'rate' has no times of writing");
    if (watches_.size() >= kMostWatches) return fail(kTooMany, "this client watches 1024 ports already");
    if (watches_.count(textOf(id)) != 0) return fail(kMalformed, "a watch has this id already");
    made.id = id;
    made.path = port->get<std::string>();
    made.period = rate > 0 ? std::llround(kSecond / rate) : 0;
    const unsigned waiting =
        made.period != 0 && message.find("buffer") == message.end() ? 0 : static_cast<unsigned>(buffer);
    made.channel = ++lastChannel_;
    json answer;
    try {
        const SampleForm samples = isBinary ? SampleForm::Cdr : SampleForm::Json;
        made.port = client_.host().watch(made.path, {samples, waiting, times == true, client_.number()});
        answer = {{"type", made.port->type()}, {"fields", fieldsOf(made.port->value())}};
        if (isBinary) {
            made.batches = std::make_unique<SampleBatches>(made.channel);
            answer["stream"] = made.batches->stream();
            answer.update(schemaOf(*made.port));
            client_.queue().setLimit(kQueueOfRecorder);
        }
    } catch (const Failure& failure) {
        return fail(failure.code(), failure.what());
    }
    client_.sendText(oroAnswer(id, std::move(answer)));
    watches_.emplace(textOf(id), std::move(made));
    client_.host().wantsChanged();
}

void OroStreams::log(const json& message, const json& id) {
    Log made;
    const auto level = message.find("level");
    if (level != message.end() && !level->is_null() &&
        !(level->is_string() && parseLevel(level->get<std::string>(), made.level)))
        return client_.sendText(oroError(id, kMalformed, kLevelExpected));
    if (!message.value("follow", json(true)).is_boolean() || !message.value("follow", true))
        return client_.sendText(oroError(id, kMalformed, "'oro.lines' gives lines of the past; 'follow' must be true"));
    if (logs_.size() >= kMostLogs) return client_.sendText(oroError(id, kTooMany, "256 streams of the log"));
    made.id = id;
    made.channel = ++lastChannel_;
    made.before = lostLines_;
    if (!logs_.emplace(textOf(id), made).second)
        return client_.sendText(oroError(id, kMalformed, "a stream of the log has this id already"));
    // First, so that the client gets what is logged after the answer.
    client_.host().wantsChanged();
    client_.sendText(oroAnswer(id, json::object()));
}

void OroStreams::end(const json& message, const json& id, const char* field) {
    const std::string key = textOf(message.value(field, json()));
    const auto watch = watches_.find(key);
    const auto log = logs_.find(key);
    if (field == std::string("watch") && watch != watches_.end()) {
        endWatch(watch->second, message, id);
        watches_.erase(watch);
        return client_.host().wantsChanged();
    } else if (field == std::string("log") && log != logs_.end()) {
        const std::uint64_t channel = log->second.channel;
        logs_.erase(log);
        if (message.value("rest", json(false)) == true) {
            client_.queue().addBehind(channel, {oroAnswer(id, json::object()), false});
            return client_.host().wantsChanged();
        }
        client_.queue().forget(channel);
    } else {
        return client_.sendText(oroError(id, kNoSuchStream, std::string("no ") + field + " has the id " + key));
    }
    client_.sendText(oroAnswer(id, json::object()));
    client_.host().wantsChanged();
}

void OroStreams::endWatch(Watch& watch, const json& message, const json& id) {
    const json rest = message.value("rest", json(false));
    json answer = json::object();
    if (watch.batches && rest == true) (void)readAll(watch, 0);
    if (watch.batches) answer["next"] = watch.batches->next();
    watch.port.reset();  // before the answer, which tells that the port is free
    const Frame frame{oroAnswer(id, std::move(answer)), false};
    if (watch.batches && rest == true) return client_.queue().addBehind(watch.channel, frame);
    client_.queue().forget(watch.channel);
    client_.sendText(frame.bytes);
}

void OroStreams::onTick(std::int64_t now) {
    bool someEnded = false;
    for (auto at = watches_.begin(); at != watches_.end();) {
        if (readAll(at->second, now)) {
            ++at;
        } else {
            client_.queue().addBehind(at->second.channel, {oroError(at->second.id, kGone,
                                                                    "port '" + at->second.path +
                                                                        "' was destroyed or disconnected, or keeps no "
                                                                        "last sample any more; the watch has ended"),
                                                           false});
            at = watches_.erase(at);
            someEnded = true;
        }
    }
    if (someEnded) client_.host().wantsChanged();
}

bool OroStreams::readAll(Watch& watch, std::int64_t now) {
    const bool isConnected = watch.port->isConnected();
    if (watch.batches) {
        watch.batches->readAll(*watch.port, client_.queue(), kMostAtOnce);
        return isConnected;
    }
    if (now < watch.next) return isConnected;
    std::string value;
    // With a rate, the newest of those that wait.
    bool isNew = false;
    for (unsigned i = 0; i != kMostAtOnce && watch.port->read(value); ++i) {
        isNew = true;
        if (watch.period != 0) continue;
        const std::uint64_t dropped = watch.port->dropped() + client_.queue().dropped(watch.channel);
        client_.queue().addSample(watch.channel, {oroSample(watch.id, watch.port->time(), value, dropped), false});
    }
    if (isNew && watch.period != 0) {
        const std::uint64_t dropped = client_.queue().dropped(watch.channel);
        client_.queue().addSample(watch.channel, {oroSample(watch.id, watch.port->time(), value, dropped), false});
        watch.next = now + watch.period - std::int64_t(kWatchPeriod) * 500000;
    }
    return isConnected;
}

void OroStreams::onLines(const std::vector<LogLine>& lines, std::uint64_t dropped) {
    lostLines_ = dropped;
    for (const auto& [key, log] : logs_)
        for (const LogLine& line : lines) {
            if (line.level > log.level) continue;
            const std::uint64_t lost = dropped - log.before + client_.queue().dropped(log.channel);
            client_.queue().addSample(log.channel, {textOf({{"op", "oro.line"},
                                                            {"id", log.id},
                                                            {"time", line.time},
                                                            {"level", kLogLevels[line.level]},
                                                            {"origin", line.origin},
                                                            {"text", line.text},
                                                            {"dropped", lost}}),
                                                    false});
        }
}

}  // namespace OCL::live
