// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "dropped_events.hpp"

#include "category_name.hpp"

#include <ocl/Category.hpp>
#include <rtt/Logger.hpp>
#include <rtt/internal/flow/connection_facts.hpp>
#include <rtt/internal/flow/storage_core.hpp>

#include <atomic>
#include <utility>

namespace OCL::logging {
namespace {

constexpr std::chrono::milliseconds kBetweenLooks{100};
constexpr std::chrono::seconds kBetweenReports{1};

std::atomic<unsigned long> reportedLost{0}, reportedCut{0};

}  // namespace

void DroppedEvents::lookLocked() {
    std::map<const void*, Connection> now;
    for (const RTT::base::ChannelElementBase::shared_ptr& channel : RTT::internal::storagesOf(port_)) {
        const RTT::internal::SampleStore& store = channel->storageCore()->store();
        const auto known = connections_.find(channel.get());
        Connection connection =
            known != connections_.end() ? known->second : Connection{channel, writerOf(*channel), store.capacity(), 0};
        const std::size_t dropped = store.dropped();
        Counts& counts = categories_[connection.category];
        counts.capacity = connection.capacity;
        counts.dropped += dropped - connection.dropped;
        connection.dropped = dropped;
        now.emplace(channel.get(), std::move(connection));
    }
    // Connections that are gone: what they dropped in the end.
    for (const auto& [address, connection] : connections_)
        if (!now.count(address))
            categories_[connection.category].dropped +=
                connection.channel->storageCore()->store().dropped() - connection.dropped;
    connections_.swap(now);
    looked_ = Clock::now();
}

void DroppedEvents::look(bool must) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (must || Clock::now() - looked_ >= kBetweenLooks) lookLocked();
}

void DroppedEvents::report(bool final) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const Clock::time_point now = Clock::now();
    if (!final && now - reported_ < kBetweenReports) return;
    bool any = false;
    for (auto& [category, counts] : categories_) {
        const std::size_t news = counts.dropped - counts.reported;
        if (news == 0) continue;
        counts.reported = counts.dropped;
        any = true;
        RTT::log(RTT::Warning) << "appender '" << owner_ << "': " << news << " events of category '" << category
                               << "' were dropped, because the buffer of " << counts.capacity
                               << " events was full; a larger BufferSize of the logging service, or a larger "
                                  "MaxEventsPerCycle or shorter period of the appender, gives them room"
                               << RTT::endlog();
    }
    if (any) reported_ = now;
    reportLackOfMemory(owner_);
}

std::size_t DroppedEvents::all() {
    const std::lock_guard<std::mutex> lock(mutex_);
    lookLocked();
    std::size_t sum = 0;
    for (const auto& entry : categories_) sum += entry.second.dropped;
    return sum;
}

std::size_t DroppedEvents::of(const std::string& category) {
    const std::lock_guard<std::mutex> lock(mutex_);
    lookLocked();
    const auto found = categories_.find(category);
    return found == categories_.end() ? 0 : found->second.dropped;
}

void reportLackOfMemory(const std::string& owner) {
    const unsigned long lost = Category::lostMessages();
    const unsigned long lostBefore = reportedLost.exchange(lost);
    if (lost > lostBefore)
        RTT::log(RTT::Warning) << "appender '" << owner << "': " << lost - lostBefore
                               << " messages of this process were lost, because too many threads logged at once"
                               << RTT::endlog();
    const unsigned long cut = LoggingEvent::cutTexts();
    const unsigned long cutBefore = reportedCut.exchange(cut);
    if (cut > cutBefore)
        RTT::log(RTT::Warning) << "appender '" << owner << "': " << cut - cutBefore
                               << " messages of this process were cut, because real-time memory is used up; the "
                                  "deployers take --rtalloc-mem-size"
                               << RTT::endlog();
}

}  // namespace OCL::logging
