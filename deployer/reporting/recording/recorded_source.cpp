// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "recorded_source.hpp"

#include <reporting/mcap_file/about.hpp>
#include <rtt/Logger.hpp>
#include <rtt/internal/flow/connection_facts.hpp>
#include <rtt/internal/flow/sample_store.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <utility>

namespace OCL::recording {
namespace {

namespace mcap = oroforge::mcap;
using RTT::encoding::ByteOrder;
using RTT::encoding::Plan;

/** In front of each value: plain CDR in the order of this machine. */
constexpr unsigned char kCdrHead[4] = {0, RTT::encoding::kNativeOrder == ByteOrder::Little ? 1 : 0, 0, 0};

std::string hexOf(std::uint64_t number) {
    char text[17];
    (void)std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(number));
    return text;
}

}  // namespace

std::unique_ptr<RecordedSource> RecordedSource::make(std::shared_ptr<reporting::Source> source, const Options& options,
                                                     std::atomic<std::uint64_t>& allLost, std::string& why) {
    const RTT::types::TypeInfo& type = *source->sample()->getTypeInfo();
    RTT::encoding::SchemaText schema;
    if (!RTT::encoding::describeType(type, options.language, options.rosNames, schema, why)) return nullptr;
    std::shared_ptr<const Plan> plan = Plan::make(type, RTT::encoding::cdrRules(), why);
    if (!plan) return nullptr;
    return std::unique_ptr<RecordedSource>(
        new RecordedSource(std::move(source), std::move(plan), std::move(schema), allLost));
}

RecordedSource::RecordedSource(std::shared_ptr<reporting::Source> source, std::shared_ptr<const Plan> plan,
                               RTT::encoding::SchemaText schema, std::atomic<std::uint64_t>& allLost)
    : source_(std::move(source)),
      plan_(std::move(plan)),
      schema_(std::move(schema)),
      sample_(source_->sample()->getRawConstPointer()),
      allLost_(allLost) {
    std::string why;
    stamp_ = RTT::encoding::Stamp::make(*source_->sample()->getTypeInfo(), why);
    if (!why.empty())
        RTT::log(RTT::Error) << "messages of '" << source_->name() << "' have the time of the recorder: error: ["
                             << "MCP013"
                             << "] " << why << RTT::endlog();
    source_->prepare();
    findStores();
    dropped_ = dropped();
}

mcap::Channel RecordedSource::channel(std::uint16_t id) {
    id_ = id;
    mcap::Channel channel;
    channel.id = id;
    channel.topic = topicOf(source_->name());
    channel.encoding = "cdr";
    channel.metadata["oroforge.source"] = source_->name();
    channel.metadata["oroforge.kind"] = source_->port() ? "port" : "value";
    channel.metadata["oroforge.type"] = source_->sample()->getTypeInfo()->getTypeName();
    channel.metadata["oroforge.fingerprint"] = hexOf(plan_->fingerprint());
    for (const auto& [field, unit] : schema_.units) channel.metadata["unit." + field] = unit;
    return channel;
}

// Looking at the connections allocates, and takes longer than a small sample.
void RecordedSource::findStores() {
    if (!source_->port()) return;
    const std::uint64_t changes = RTT::internal::connectionChanges();
    if (changes == connectionChanges_) return;
    connectionChanges_ = changes;
    stores_ = RTT::internal::storagesOf(*source_->port());
}

std::size_t RecordedSource::dropped() const { return RTT::internal::droppedIn(stores_); }

void RecordedSource::lose(std::uint64_t count) {
    sequence_ += static_cast<std::uint32_t>(count);
    lost_.fetch_add(count, std::memory_order_relaxed);
    allLost_.fetch_add(count, std::memory_order_relaxed);
}

void RecordedSource::countDropped() {
    const std::size_t dropped = this->dropped();
    if (dropped > dropped_) lose(dropped - dropped_);
    dropped_ = dropped;  // smaller: the connection is another one
}

bool RecordedSource::addSamples(ChunkPipe& pipe, const std::function<std::uint64_t()>& now, unsigned most) {
    if (!source_->port()) return false;
    if (!source_->read()) return false;  // and so nothing was dropped since the last one
    findStores();
    countDropped();
    ChunkPipe::Filling filling(pipe);
    for (;;) {
        add(filling, now());
        if (--most == 0 || !source_->read()) return true;
        countDropped();
    }
}

void RecordedSource::add(ChunkPipe::Filling& filling, std::uint64_t now) {
    std::size_t left = 0, size = 0;
    unsigned char* place = filling.place(left);
    if (place && left > sizeof kCdrHead) size = plan_->encode(sample_, place + sizeof kCdrHead, left - sizeof kCdrHead);
    if (size == 0) {
        // There is not enough room in this chunk.
        size = plan_->sizeOf(sample_);
        if (size == 0 && !std::exchange(isUnencodable_, true))
            RTT::log(RTT::Error) << "a value of '" << source_->name()
                                 << "' cannot be recorded: it nests too deeply, or a function of its type throws"
                                 << RTT::endlog();
        place = size == 0 ? nullptr : filling.placeFor(size + sizeof kCdrHead);
        if (!place || plan_->encode(sample_, place + sizeof kCdrHead, size) != size) return lose(1);
    }
    std::memcpy(place, kCdrHead, sizeof kCdrHead);
    const std::uint64_t made = stamp_ ? stamp_->read(sample_) : 0;
    filling.add({id_, sequence_++, now, made != 0 ? made : now, nullptr, size + sizeof kCdrHead, 0});
}

void RecordedSource::addValue(ChunkPipe& pipe, std::uint64_t now) {
    if (source_->port()) return;
    (void)source_->read();
    now_.resize(plan_->sizeOf(sample_));
    const bool good = !now_.empty() && plan_->encode(sample_, now_.data(), now_.size()) == now_.size();
    if (good && now_ == last_) return;
    now_.swap(last_);
    ChunkPipe::Filling filling(pipe);
    add(filling, now);
}

void RecordedSource::forgetSamples() {
    source_->clear();
    findStores();
    dropped_ = dropped();
}

}  // namespace OCL::recording
