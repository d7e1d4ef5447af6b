// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/compile/compiler.hpp>

#include <rtt/OperationInterfacePart.hpp>

#include <algorithm>
#include <atomic>

namespace RTT::scripting::detail {

boost::shared_ptr<const OperationInterfacePart> Scope::Handle::operation() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return operation_;
}

base::DataSourceBase::shared_ptr Scope::Handle::source() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return source_;
}

void Scope::Handle::set(boost::shared_ptr<const OperationInterfacePart> operation,
                        base::DataSourceBase::shared_ptr source) {
    const std::lock_guard<std::mutex> lock(mutex_);
    // The old value is destroyed with the arguments, without the lock.
    operation_.swap(operation);
    source_.swap(source);
}

// relaxed: a thread gets numbers of others together with a scope or function, under a lock.
Scope::Time Scope::now() {
    static std::atomic<Time> last{0};
    return last.fetch_add(1, std::memory_order_relaxed) + 1;
}

const Scope::Entry* Scope::find(const std::string& name, Time since) const {
    for (const Scope* scope = this; scope; scope = scope->parent_) {
        const Entry* const found = scope->findHere(name);
        if (found && found->declared < since) return found;
        since = std::min(since, scope->since_);
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
    entry.declared = now();
    return entries_.emplace(name, std::move(entry)).second;
}

std::map<std::string, Scope::Entry> Scope::entries() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return entries_;
}

}  // namespace RTT::scripting::detail
