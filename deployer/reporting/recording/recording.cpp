// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "recording.hpp"

#include "about.hpp"

#include <reporting/mcap_file/log_message.hpp>
#include <rtt/Logger.hpp>
#include <rtt/os/TimeService.hpp>

#include <algorithm>
#include <chrono>
#include <utility>

namespace OCL::recording {
namespace {

namespace mcap = oroforge::mcap;

/** The most samples of one port in one cycle, so that a writer that never pauses cannot prevent a stop. */
constexpr unsigned kSamplesPerCycle = 10000;

/** Numbers of channels have 16 bits; some are for the recorder's own. */
constexpr std::size_t kMostChannels = 65500;

std::int64_t timeOfDay() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::system_clock::now().time_since_epoch())
        .count();
}

}  // namespace

std::unique_ptr<Recording> Recording::make(const reporting::Sources& sources, const RecordingOptions& options) {
    std::unique_ptr<Recording> result(new Recording(options));
    for (const std::shared_ptr<reporting::Source>& source : sources) result->add(source);
    if (!options.peers.empty()) result->addStates();
    if (options.hasLog) result->addLog();
    if (!result->begin()) return nullptr;
    return result;
}

Recording::Recording(const RecordingOptions& options)
    : options_(options), toClock_(options.realtime ? timeOfDay() - RTT::os::TimeService::Instance()->getNSecs() : 0) {
    content_.file = options.file;
    content_.header = {"ros2", "oroforge " OROFORGE_VERSION};
    content_.about = aboutRecording(options);
    content_.atEnd = [this] { return atEnd(); };
    content_.compression = options.compression;
}

Recording::~Recording() {
    if (pipe_) pipe_->finish();
}

void Recording::add(const std::shared_ptr<reporting::Source>& source) {
    std::string why;
    std::unique_ptr<RecordedSource> added = RecordedSource::make(source, options_.sources, lostOfSources_, why);
    if (!added || content_.channels.size() == kMostChannels) {
        RTT::log(RTT::Error) << "'" << options_.component << "' does not record '" << source->name() << "': error: ["
                             << "MCP011"
                             << "] " << (added ? "a file has at most 65500 channels" : why) << RTT::endlog();
        return;
    }
    if (options_.sources.language == RTT::encoding::SchemaLanguage::Auto && !added->schema().illegal.empty())
        RTT::log(RTT::Info) << "'" << source->name()
                            << "' is described by IDL, which not all viewers read: " << added->schema().illegal
                            << "; RosNames=true gives its fields names that ROS takes" << RTT::endlog();
    mcap::Channel channel = added->channel(static_cast<std::uint16_t>(content_.channels.size() + 1));
    channel.schema = schemaOf(added->schema());
    content_.channels.push_back(std::move(channel));
    if (source->port())
        ports_[source->port()] = sources_.size();
    else
        values_.push_back(sources_.size());
    sources_.push_back(std::move(added));
    hasData_.push_back(false);
}

std::uint16_t Recording::schemaOf(const RTT::encoding::SchemaText& text) {
    for (const mcap::Schema& known : content_.schemas)
        if (known.name == text.name && known.encoding == text.encoding && known.data == text.text) return known.id;
    const auto id = static_cast<std::uint16_t>(content_.schemas.size() + 1);
    content_.schemas.push_back({id, text.name, text.encoding, text.text});
    return id;
}

void Recording::addStates() {
    const auto schema = static_cast<std::uint16_t>(content_.schemas.size() + 1);
    const auto channel = static_cast<std::uint16_t>(content_.channels.size() + 1);
    // Other processes are not the same each time, and looking at many components takes longer than a sample.
    states_.reset(new StateChannel(options_.peers, options_.isReproducible));
    content_.schemas.push_back(StateChannel::schema(schema));
    content_.channels.push_back(states_->channel(channel, schema));
}

void Recording::addLog() {
    const auto schema = static_cast<std::uint16_t>(content_.schemas.size() + 1);
    const auto channel = static_cast<std::uint16_t>(content_.channels.size() + 1);
    log_.reset(new LogChannel(options_.realtime));
    content_.schemas.push_back(logSchema(schema));
    content_.channels.push_back(log_->channel(channel, schema));
}

bool Recording::begin() {
    ChunkTaker* taker = nullptr;
    if (options_.ring > 0) {
        last_.reset(new LastChunks(content_, options_.ring, options_.ringSize));
        taker = last_.get();
    } else {
        file_.reset(new FileTaker(content_, options_.split));
        taker = file_.get();
        if (!file_->error().empty()) {
            RTT::log(RTT::Error) << file_->error() << RTT::endlog();
            return false;
        }
    }
    const auto onLoss = [this, told = false]() mutable {
        if (failed() && !std::exchange(told, true)) options_.onFailure();
    };
    pipe_.reset(
        new ChunkPipe({options_.component + ".Writer", options_.chunkSize, options_.chunkTime, options_.isReproducible},
                      *taker, onLoss));
    writeRow();
    if (states_) states_->add(*pipe_, now());
    return true;
}

std::uint64_t Recording::now() const {
    const std::int64_t time = RTT::os::TimeService::Instance()->getNSecs() + toClock_;
    return static_cast<std::uint64_t>(std::max<std::int64_t>(time, 0));
}

bool Recording::readSource(std::size_t source) {
    return sources_[source]->addSamples(
        *pipe_, [this] { return now(); }, kSamplesPerCycle);
}

// In the order of the sources, whichever port was the first: messages of one time are in the same order each time.
bool Recording::readSources() {
    bool any = false;
    if (!isWoken_) {
        for (std::size_t i = 0; i != sources_.size(); ++i) any |= readSource(i);
        return any;
    }
    std::sort(withData_.begin(), withData_.end());
    std::size_t left = 0;
    for (const std::size_t source : withData_) {
        hasData_[source] = readSource(source);
        if (hasData_[source]) withData_[left++] = source;
    }
    withData_.resize(left);
    return left != 0;
}

void Recording::mark(std::size_t source) {
    if (hasData_[source]) return;
    hasData_[source] = true;
    withData_.push_back(source);
}

void Recording::hasData(const RTT::base::PortInterface* port) {
    if (const auto found = ports_.find(port); isWoken_ && found != ports_.end()) mark(found->second);
}

bool Recording::read() {
    if (states_) states_->add(*pipe_, now());
    if (log_) log_->add(*pipe_);
    const bool any = readSources();
    if (lost() != 0 && !std::exchange(everLost_, true))
        RTT::log(RTT::Error)
            << "a message of the recording of '" << options_.component
            << "' is lost: its buffer is too small for its period (see ReportPolicy), or the disk does "
               "not take them as fast as they come"
            << RTT::endlog();
    return any;
}

void Recording::writeRow() {
    for (const std::size_t value : values_) sources_[value]->addValue(*pipe_, now());
}

void Recording::clearPorts() {
    for (const auto& source : sources_) source->forgetSamples();
}

void Recording::wakeOnData(bool on) {
    isWoken_ = on;
    withData_.clear();
    std::fill(hasData_.begin(), hasData_.end(), false);
    for (const auto& port : ports_) mark(port.second);  // what is there already wakes nobody
    for (const auto& source : sources_)
        if (RTT::base::InputPortInterface* const port = source->port()) port->signalInterface(on);
}

void Recording::finish() {
    // Samples and lines from before stop() belong to the recording.
    if (log_) log_->end();
    (void)read();
    pipe_->finish();
    if (file_) file_->finish();
    if (lost() != 0)
        RTT::log(RTT::Error) << lost() << " messages of the recording of '" << options_.component << "' are lost"
                             << RTT::endlog();
}

unsigned long Recording::lost() const {
    const unsigned long sum = (pipe_ ? pipe_->lost() : 0) + (states_ ? states_->lost() : 0) + (log_ ? log_->lost() : 0);
    return sum + lostOfSources_.load(std::memory_order_relaxed);
}

/** What is known to be lost so far. Called by the thread of the pipe, too. */
mcap::Metadata Recording::atEnd() const {
    mcap::Metadata result{"oroforge.lost", {}};
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i != sources_.size(); ++i) {
        const std::uint64_t lost = sources_[i]->lost();
        sum += lost;
        if (lost != 0) result.texts[content_.channels[i].topic] = std::to_string(lost);
    }
    const auto addOwn = [&](const char* topic, std::uint64_t lost) {
        sum += lost;
        if (lost != 0) result.texts[topic] = std::to_string(lost);
    };
    if (states_) addOwn("/oroforge/states", states_->lost());
    if (log_) addOwn("/rosout", log_->lost());
    result.texts["all"] = std::to_string(sum);
    return result;
}

}  // namespace OCL::recording
