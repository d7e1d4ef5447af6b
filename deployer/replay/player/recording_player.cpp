// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "recording_player.hpp"

#include "recorded_channel.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace OCL::replay {
namespace {

namespace mcap = oroforge::mcap;

constexpr std::uint64_t kLatest = std::numeric_limits<RTT::nsecs>::max();

RTT::nsecs timeOf(std::uint64_t time) { return static_cast<RTT::nsecs>(std::min(time, kLatest)); }

std::string secondsOf(std::uint64_t time) {
    char text[48];
    (void)std::snprintf(text, sizeof text, "%llu.%09llu", static_cast<unsigned long long>(time / 1000000000U),
                        static_cast<unsigned long long>(time % 1000000000U));
    return text;
}

}  // namespace

std::unique_ptr<RecordingPlayer> RecordingPlayer::open(const std::string& file, const PlayerOptions& options,
                                                       std::string& error) {
    std::unique_ptr<mcap::Source> source = mcap::openSource(file, error);
    if (!source) {
        error = file + ": error: [MCP010] the recording cannot be read: " + error;
        return nullptr;
    }
    std::unique_ptr<RecordingPlayer> player(new RecordingPlayer(file, options, std::move(source)));
    player->learn();
    if (!player->topics_.empty()) return player;
    const std::vector<std::string> problems = player->problems();
    error = problems.empty() ? file + ": error: [MCP020] the recording has no port" : problems.front();
    return nullptr;
}

RecordingPlayer::RecordingPlayer(std::string file, const PlayerOptions& options, std::unique_ptr<mcap::Source> source)
    : file_(std::move(file)), options_(options), source_(std::move(source)) {}

RecordingPlayer::~RecordingPlayer() = default;

void RecordingPlayer::learn() {
    contents_ = mcap::readContents(*source_, [this](const mcap::Problem& one) { problems_.add(one.line(file_)); });
    begin_ = timeOf(contents_.start);
    end_ = timeOf(contents_.end);
    for (const mcap::Metadata& one : contents_.metadata)
        if (one.name == "oroforge") metadata_ = one.texts;
    for (const auto& [id, channel] : contents_.channels)
        if (isPort(channel)) addTopic(id, channel);
}

void RecordingPlayer::addTopic(std::uint16_t id, const mcap::Channel& channel) {
    Topic topic = topicOf(channel, schemaOf(channel));
    if (topic.port.empty())
        return problems_.add(file_ + ": error: [MCP020] channel " + std::to_string(id) + " is left out: its topic '" +
                             channel.topic + "' has no name");
    const auto known =
        std::find_if(topics_.begin(), topics_.end(), [&](const Topic& one) { return one.topic == topic.topic; });
    const auto at = static_cast<std::size_t>(known - topics_.begin());
    if (known == topics_.end()) {
        topics_.push_back(std::move(topic));
        ports_.emplace_back();
    }
    channels_[id].topic = at;
    if (const auto count = contents_.counts.find(id); count != contents_.counts.end())
        topics_[at].count += count->second;
}

const mcap::Schema* RecordingPlayer::schemaOf(const mcap::Channel& channel) const {
    const auto found = contents_.schemas.find(channel.schema);
    return found == contents_.schemas.end() ? nullptr : &found->second;
}

std::string RecordingPlayer::located(const Refusal& refusal, const std::string& topic) const {
    return file_ + ": error: [" + refusal.code + "] topic '" + topic + "': " + refusal.text;
}

RTT::base::OutputPortInterface* RecordingPlayer::port(const std::string& topic, std::string& problem) {
    problem.clear();
    const auto known =
        std::find_if(topics_.begin(), topics_.end(), [&](const Topic& one) { return one.topic == topic; });
    if (known == topics_.end()) {
        problem = located({"MCP020", "the recording has no such port"}, topic);
        return nullptr;
    }
    const auto at = static_cast<std::size_t>(known - topics_.begin());
    if (ports_[at]) return &ports_[at]->port();
    std::unique_ptr<RepeatedPort> made;
    for (auto& [id, channel] : channels_) {
        if (channel.topic != at) continue;
        std::string why;
        const mcap::Channel& recorded = contents_.channels.at(id);
        const RTT::types::TypeInfo* const type = typeOf(recorded, schemaOf(recorded), why);
        const std::string& path = known->port;
        if (!type)
            problem = located({"MCP021", why}, topic);
        else if (!made && !(made = RepeatedPort::make(*type, path.substr(path.rfind('.') + 1))))
            problem = located({"MCP021", "its type '" + type->getTypeName() + "' has no ports"}, topic);
        else if (&made->type() != type)
            problem = located({"MCP023", "its messages have the types '" + made->type().getTypeName() + "' and '" +
                                             type->getTypeName() + "', and a port has one"},
                              topic);
        else if (connect(id, *made, problem))
            continue;
        for (auto& [other, one] : channels_)
            if (one.topic == at) one.decoder.reset();
        return nullptr;
    }
    ports_[at] = std::move(made);
    // The messages that are not delivered yet are those of the new port, too.
    if (messages_) begin(delivered_ ? static_cast<std::uint64_t>(*delivered_) + 1 : from_);
    return &ports_[at]->port();
}

bool RecordingPlayer::connect(std::uint16_t id, RepeatedPort& port, std::string& problem) {
    const mcap::Channel& channel = contents_.channels.at(id);
    Refusal refusal;
    channels_[id].decoder = MessageDecoder::make(port.type(), channel, schemaOf(channel), options_.tolerate, refusal);
    if (refusal.code) problem = located(refusal, channel.topic);
    return channels_[id].decoder != nullptr;
}

void RecordingPlayer::seek(RTT::nsecs from, RTT::nsecs to) {
    from_ = static_cast<std::uint64_t>(std::max<RTT::nsecs>(from, 0));
    to_ = static_cast<std::uint64_t>(std::max<RTT::nsecs>(to, 0));
    messages_.reset();
    ahead_ = nullptr;
    due_ = 0;
    delivered_.reset();
}

void RecordingPlayer::begin(std::uint64_t from) {
    mcap::Selection selection;
    selection.start = from;
    selection.end = to_;
    for (const auto& [id, channel] : channels_)
        if (channel.decoder) selection.channels.insert(id);
    // No channel would mean all of them.
    const std::vector<mcap::Piece> none;
    messages_.reset(new mcap::InOrder(*source_, selection.channels.empty() ? none : contents_.pieces, contents_.ids(),
                                      selection, [this](const mcap::Problem& one) { problems_.add(one.line(file_)); }));
    advance();
}

void RecordingPlayer::advance() {
    ahead_ = messages_->next();
    if (!ahead_) return;
    const RTT::nsecs time = timeOf(ahead_->logTime);
    if (time < due_)
        problems_.add("order", file_ + ": error: [" + "MCP026" + "] a message at " + secondsOf(ahead_->logTime) +
                                   " comes after later ones, because the index has wrong times; it is replayed late");
    due_ = std::max(due_, time);
}

std::optional<RTT::nsecs> RecordingPlayer::next() {
    if (!messages_) begin(from_);
    return ahead_ ? std::optional<RTT::nsecs>(due_) : std::nullopt;
}

void RecordingPlayer::deliver() {
    const std::optional<RTT::nsecs> now = next();
    if (now) delivered_ = now;
    while (ahead_ && due_ == *now) {
        write(*ahead_);
        advance();
    }
}

void RecordingPlayer::write(const mcap::Message& message) {
    const Channel& channel = channels_.at(message.channel);
    const std::string problem = ports_[channel.topic]->write(*channel.decoder, message);
    if (problem.empty()) {
        ++written_;
        return;
    }
    ++leftOut_;
    const std::string& topic = topics_[channel.topic].topic;
    problems_.add("message " + topic, located({"MCP025", "the message at " + secondsOf(message.logTime) +
                                                             " does not fit its type: " + problem},
                                              topic));
}

}  // namespace OCL::replay
