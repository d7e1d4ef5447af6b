// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/compiler.hpp>

namespace RTT {
namespace scripting {
namespace detail {

const Scope::Entry* Scope::find(const std::string& name, const Entry* other) const {
    for (const Scope* scope = this; scope; scope = scope->parent_) {
        const Entry* const found = scope->findHere(name);
        if (found && found != other) return found;
    }
    return nullptr;
}

void Scope::markLoop(const std::string& name, Entry::Loop loop) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = entries_.find(name);
    if (found != entries_.end()) found->second.loop = loop;
}

const Scope::Entry* Scope::findHere(const std::string& name) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = entries_.find(name);
    return found == entries_.end() ? nullptr : &found->second;
}

bool Scope::add(const std::string& name, Entry entry) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return entries_.emplace(name, std::move(entry)).second;
}

std::map<std::string, Scope::Entry> Scope::entries() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return entries_;
}

}  // namespace detail
}  // namespace scripting
}  // namespace RTT
