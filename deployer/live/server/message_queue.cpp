// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "message_queue.hpp"

#include <algorithm>
#include <utility>

namespace OCL::live {

void MessageQueue::addAnswer(Frame frame) {
    answerBytes_ += frame.bytes.size();
    answers_.push_back(std::move(frame));
}

void MessageQueue::addSample(std::uint64_t channel, Frame frame) {
    const std::size_t size = frame.bytes.size();
    makeRoom(size, channel);
    const Turn turn = ++last_;
    sampleBytes_ += size;
    channels_[channel].waiting.emplace(turn, std::move(frame));
    order_.emplace(turn, channel);
}

void MessageQueue::addBehind(std::uint64_t channel, Frame frame) {
    Channel& own = channels_[channel];
    own.behind.push_back(std::move(frame));
    if (!own.waiting.empty()) return;
    release(own);
    channels_.erase(channel);
}

void MessageQueue::release(Channel& channel) {
    for (Frame& frame : channel.behind) addAnswer(std::move(frame));
    channel.behind.clear();
}

void MessageQueue::makeRoom(std::size_t size, std::uint64_t channel) {
    Channel& own = channels_[channel];
    while (sampleBytes_ + size > limit_ && !own.waiting.empty()) drop(channel);
    while (sampleBytes_ + size > limit_ && !order_.empty()) {
        const auto notNewest = std::find_if(order_.begin(), order_.end(), [this](const auto& entry) {
            return channels_[entry.second].waiting.size() > 1;
        });
        drop(notNewest == order_.end() ? order_.begin()->second : notNewest->second);
    }
}

void MessageQueue::drop(std::uint64_t channel) {
    Channel& from = channels_[channel];
    const auto oldest = from.waiting.begin();
    sampleBytes_ -= oldest->second.bytes.size();
    order_.erase(oldest->first);
    from.waiting.erase(oldest);
    ++from.dropped;
    if (from.waiting.empty()) release(from);
}

bool MessageQueue::next(Frame& frame) {
    if (!answers_.empty()) {
        frame = std::move(answers_.front());
        answers_.pop_front();
        answerBytes_ -= frame.bytes.size();
        return true;
    }
    if (order_.empty()) return false;
    const auto oldest = order_.begin();
    Channel& from = channels_[oldest->second];
    const std::uint64_t channel = oldest->second;
    frame = std::move(from.waiting.begin()->second);
    sampleBytes_ -= frame.bytes.size();
    from.waiting.erase(from.waiting.begin());
    order_.erase(oldest);
    if (!from.waiting.empty() || from.behind.empty()) return true;
    release(from);
    channels_.erase(channel);
    return true;
}

void MessageQueue::forget(std::uint64_t channel) {
    const auto found = channels_.find(channel);
    if (found == channels_.end()) return;
    while (!found->second.waiting.empty()) drop(channel);
    channels_.erase(found);
}

std::uint64_t MessageQueue::dropped(std::uint64_t channel) const {
    const auto found = channels_.find(channel);
    return found == channels_.end() ? 0 : found->second.dropped;
}

}  // namespace OCL::live
