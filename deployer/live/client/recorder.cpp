// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "recorder.hpp"

#include "failure.hpp"

#include <reporting/mcap_file/about.hpp>
#include <reporting/mcap_file/log_message.hpp>

#include <algorithm>
#include <cstring>
#include <utility>

namespace oroforge::live_client {
namespace {

constexpr std::size_t kChunk = std::size_t(1) << 20;
constexpr std::chrono::milliseconds kChunkTime{500};
/** Numbers of channels have 16 bits. */
constexpr std::size_t kMostTopics = 65500;
constexpr unsigned char kSamples = 0x80;
constexpr std::size_t kHead = 5, kSampleHead = 20;  // of a binary message, and of a sample in it

OCL::recording::LogLevel levelOf(const std::string& name) {
    using Level = OCL::recording::LogLevel;
    static const std::map<std::string, Level> kLevels{{"Fatal", Level::Fatal},
                                                      {"Critical", Level::Fatal},
                                                      {"Error", Level::Error},
                                                      {"Warning", Level::Warning},
                                                      {"Info", Level::Info}};
    const auto found = kLevels.find(name);
    return found == kLevels.end() ? Level::Debug : found->second;
}

}  // namespace

Recorder::Recorder(const Options& options, mcap::Texts about) : chunk_(kChunk) {
    content_.file = options.file;
    content_.header = {"ros2", "oroforge " OROFORGE_VERSION};
    content_.about = {{"oroforge", std::move(about)}};
    content_.atEnd = [this] { return atEnd(); };
    content_.compression = options.compression;
    files_ = std::make_unique<OCL::recording::FileSequence>(content_, options.split, options.keepsOthers);
    check(!files_->failed());
}

void Recorder::check(bool good) const {
    if (!good) throw Failure(Status::Refused, files_->error());
}

std::uint16_t Recorder::schemaOf(const std::string& name, const std::string& encoding, const std::string& text) {
    for (const mcap::Schema& known : content_.schemas)
        if (known.name == name && known.encoding == encoding && known.data == text) return known.id;
    const auto id = static_cast<std::uint16_t>(content_.schemas.size() + 1);
    content_.schemas.push_back({id, name, encoding, text});
    check(files_->add(content_.schemas.back()));
    return id;
}

/** A component that comes again goes on with its topic, if its type is the same. */
Recorder::Topic* Recorder::topicFor(mcap::Channel channel) {
    for (const mcap::Channel& known : content_.channels)
        if (known.topic == channel.topic && known.schema == channel.schema && known.metadata == channel.metadata)
            return &topics_[known.id];
    if (content_.channels.size() == kMostTopics) return nullptr;
    channel.id = static_cast<std::uint16_t>(content_.channels.size() + 1);
    content_.channels.push_back(std::move(channel));
    check(files_->add(content_.channels.back()));
    Topic& topic = topics_[content_.channels.back().id];
    topic.channel = content_.channels.back().id;
    return &topic;
}

bool Recorder::addPort(const std::string& port, const Json& answer, std::string& why) {
    const Json& schema = memberOf(answer, "schema");
    mcap::Channel channel;
    channel.schema = schemaOf(textOf(schema, "name"), textOf(schema, "encoding"), textOf(schema, "text"));
    channel.topic = OCL::recording::topicOf(port);
    channel.encoding = "cdr";
    channel.metadata["oroforge.source"] = port;
    channel.metadata["oroforge.kind"] = "port";
    channel.metadata["oroforge.type"] = textOf(answer, "type");
    channel.metadata["oroforge.fingerprint"] = textOf(answer, "fingerprint");
    for (const auto& unit : memberOf(answer, "units").items())
        channel.metadata["unit." + unit.key()] = unit.value().is_string() ? unit.value().get<std::string>() : "";
    Topic* const topic = topicFor(std::move(channel));
    why = "a file has at most 65500 channels";
    if (topic) streams_[static_cast<std::uint32_t>(wholeOf(answer, "stream"))] = {topic, 0};
    return topic != nullptr;
}

void Recorder::skipTo(Stream& stream, std::uint64_t number) {
    if (number <= stream.next) return;
    stream.topic->lost += number - stream.next;
    stream.topic->sequence += static_cast<std::uint32_t>(number - stream.next);
    stream.next = number;
}

void Recorder::addSamples(std::string_view message) {
    mcap::Cursor all(reinterpret_cast<const unsigned char*>(message.data()), message.size());
    if (message.size() < kHead || all.number<std::uint8_t>() != kSamples) return;
    const auto found = streams_.find(all.number<std::uint32_t>());
    if (found == streams_.end()) return;
    while (all.left() >= kSampleHead) {
        const auto size = all.number<std::uint32_t>();
        const auto time = all.number<std::uint64_t>(), number = all.number<std::uint64_t>();
        const unsigned char* const data = all.take(size);
        if (!data) break;
        skipTo(found->second, number);
        add(*found->second.topic, time, data, size);
        found->second.next = number + 1;
    }
    if (!all.good() || all.left() != 0)
        throw Failure(Status::Refused,
                      "the deployment sends a message with samples that is cut; is its version another?");
}

void Recorder::endStream(std::uint32_t stream, std::uint64_t next) {
    const auto found = streams_.find(stream);
    if (found == streams_.end()) return;
    skipTo(found->second, next);
    streams_.erase(found);
}

void Recorder::addLine(const Json& line) {
    if (!log_) {
        const mcap::Schema schema = OCL::recording::logSchema(0);
        mcap::Channel channel = OCL::recording::logChannel(0, schemaOf(schema.name, schema.encoding, schema.data));
        log_ = topicFor(std::move(channel));
        if (!log_) return;
    }
    const auto lost = static_cast<std::uint64_t>(wholeOf(line, "dropped"));
    if (lost > lostLines_) {
        log_->lost += lost - lostLines_;
        log_->sequence += static_cast<std::uint32_t>(lost - lostLines_);
        lostLines_ = lost;
    }
    const auto time = static_cast<std::uint64_t>(wholeOf(line, "time"));
    const OCL::recording::CdrText message =
        OCL::recording::logMessage(time, levelOf(textOf(line, "level")), textOf(line, "origin"), textOf(line, "text"));
    add(*log_, time, message.bytes().data(), message.bytes().size());
}

void Recorder::add(Topic& topic, std::uint64_t time, const unsigned char* data, std::size_t size) {
    unsigned char* place = chunk_.place(size);
    if (!place) {
        writeChunk();
        chunk_.grow(size);
        place = chunk_.place(size);
    }
    if (chunk_.empty()) chunkSince_ = Clock::now();
    if (size != 0) std::memcpy(place, data, size);
    chunk_.add({topic.channel, topic.sequence++, time, time, nullptr, size, 0});
    ++topic.messages;
    ++messages_;
}

void Recorder::writeChunk() {
    if (chunk_.empty()) return;
    const bool good = files_->write(chunk_);
    if (!good) messages_ -= chunk_.entries().size();
    chunk_.clear();
    check(good);
}

// The samples that come while somebody waits for this time may begin a chunk.
Deadline Recorder::due() const { return (chunk_.empty() ? Clock::now() : chunkSince_) + kChunkTime; }

void Recorder::writeDue() {
    if (Clock::now() >= due()) writeChunk();
}

void Recorder::finish() {
    writeChunk();
    check(files_->finish());
}

std::uint64_t Recorder::lost() const {
    std::uint64_t sum = 0;
    for (const auto& [channel, topic] : topics_) sum += topic.lost;
    return sum;
}

std::size_t Recorder::topics() const {
    return static_cast<std::size_t>(
        std::count_if(topics_.begin(), topics_.end(), [](const auto& one) { return one.second.messages != 0; }));
}

mcap::Metadata Recorder::atEnd() const {
    mcap::Metadata result{"oroforge.lost", {}};
    std::map<std::string, std::uint64_t> lost;
    for (const mcap::Channel& channel : content_.channels) lost[channel.topic] += topics_.at(channel.id).lost;
    for (const auto& [topic, count] : lost)
        if (count != 0) result.texts[topic] = std::to_string(count);
    result.texts["all"] = std::to_string(this->lost());
    return result;
}

}  // namespace oroforge::live_client
