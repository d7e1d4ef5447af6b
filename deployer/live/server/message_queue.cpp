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
    auto& waiting = channels_[oldest->second].waiting;
    frame = std::move(waiting.begin()->second);
    sampleBytes_ -= frame.bytes.size();
    waiting.erase(waiting.begin());
    order_.erase(oldest);
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
