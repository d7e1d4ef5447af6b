// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "MessageNames.hpp"

#include <rtt/Logger.hpp>

#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace RTT::types {

namespace {

typedef std::function<void(const MessageName&)> Watcher;

struct State {
    std::mutex mutex;
    std::map<std::string, MessageName> byType;  ///< only grows, so entries keep their place
    std::vector<std::shared_ptr<const Watcher>> watchers;
};

/** Never destroyed: typekits may be loaded while the process ends. */
State& state() {
    static State& only = *new State;
    return only;
}

}  // namespace

bool announceMessage(const char* type, const char* message, const char* md5, const char* definition) {
    State& all = state();
    std::vector<std::shared_ptr<const Watcher>> watchers;
    const MessageName* entry = nullptr;
    bool isNew = false;
    {
        const std::lock_guard<std::mutex> lock(all.mutex);
        const auto added = all.byType.emplace(type, MessageName{type, message, md5, definition});
        entry = &added.first->second;
        isNew = added.second;
        if (isNew) watchers = all.watchers;
    }
    for (const auto& told : watchers) (*told)(*entry);
    const bool isSame = entry->message == message && entry->md5 == md5;
    if (!isSame)
        log(Error) << "type " << type << " is not the message " << message << " (" << md5 << "): another typekit says"
                   << " that it is " << entry->message << " (" << entry->md5
                   << "); generate both from the same header and messages" << endlog();
    return isSame;
}

const MessageName* announcedMessage(const std::string& type) {
    State& all = state();
    const std::lock_guard<std::mutex> lock(all.mutex);
    const auto found = all.byType.find(type);
    return found == all.byType.end() ? nullptr : &found->second;
}

void watchMessages(Watcher told) {
    State& all = state();
    const auto watcher = std::make_shared<const Watcher>(std::move(told));
    std::vector<const MessageName*> known;
    {
        const std::lock_guard<std::mutex> lock(all.mutex);
        for (const auto& [type, entry] : all.byType) known.push_back(&entry);
        all.watchers.push_back(watcher);
    }
    for (const MessageName* entry : known) (*watcher)(*entry);
}

}  // namespace RTT::types
