// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_roscomm/detail/open_topics.hpp>

#include <rtt_roscomm/detail/master_watch.hpp>

#include <algorithm>
#include <mutex>

namespace rtt_roscomm::detail {

namespace {

std::mutex& mutex() {
    static std::mutex* const one = new std::mutex();
    return *one;
}
std::vector<const OpenTopic*>& all() {
    static std::vector<const OpenTopic*>* const list = new std::vector<const OpenTopic*>();
    return *list;
}

}  // namespace

void OpenTopic::show() {
    {
        const std::lock_guard<std::mutex> lock(mutex());
        all().push_back(this);
    }
    MasterWatch::instance().addUser();
}

void OpenTopic::hide() {
    {
        const std::lock_guard<std::mutex> lock(mutex());
        const auto found = std::find(all().begin(), all().end(), this);
        if (found == all().end()) return;
        all().erase(found);
    }
    MasterWatch::instance().removeUser();
}

std::vector<TopicState> openTopics() {
    std::vector<TopicState> states;
    {
        const std::lock_guard<std::mutex> lock(mutex());
        for (const OpenTopic* one : all()) states.push_back(one->state());
    }
    std::sort(states.begin(), states.end(), [](const TopicState& a, const TopicState& b) { return a.topic < b.topic; });
    return states;
}

}  // namespace rtt_roscomm::detail
