// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/proxy_registry.hpp>

#include <rtt/transports/corba/TaskContextProxy.hpp>

#include <algorithm>

namespace RTT::corba::detail {

ProxyRegistry& ProxyRegistry::instance() {
    static auto* const registry = new ProxyRegistry();  // never destroyed: proxies may be, until the process ends
    return *registry;
}

ProxyRegistry::Held::~Held() {
    if (!entry_) return;
    ProxyRegistry& registry = instance();
    const std::lock_guard<std::mutex> lock(registry.mutex_);
    if (--entry_->holders == 0) registry.left_.notify_all();
}

void ProxyRegistry::add(TaskContextProxy& proxy) {
    const std::lock_guard<std::mutex> lock(mutex_);
    all_.push_back(std::make_shared<Entry>(Entry{&proxy, 0}));
}

void ProxyRegistry::remove(TaskContextProxy& proxy) {
    std::unique_lock<std::mutex> lock(mutex_);
    const auto found =
        std::find_if(all_.begin(), all_.end(), [&](const auto& entry) { return entry->proxy == &proxy; });
    if (found == all_.end()) return;
    const std::shared_ptr<Entry> own = *found;
    all_.erase(found);
    left_.wait(lock, [&] { return own->holders == 0; });
}

ProxyRegistry::Held ProxyRegistry::findLocked(CTaskContext_ptr task) {
    for (const std::shared_ptr<Entry>& entry : all_) {
        const CTaskContext_ptr known = entry->proxy->server();
        if (CORBA::is_nil(known) || !known->_is_equivalent(task)) continue;
        ++entry->holders;
        return Held(entry);
    }
    return {};
}

ProxyRegistry::Held ProxyRegistry::find(CTaskContext_ptr task) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return findLocked(task);
}

ProxyRegistry::Held ProxyRegistry::addOrFind(TaskContextProxy& made, CTaskContext_ptr task) {
    const std::lock_guard<std::mutex> lock(mutex_);
    Held known = findLocked(task);
    if (known.get()) return known;
    all_.push_back(std::make_shared<Entry>(Entry{&made, 1}));
    return Held(all_.back());
}

}  // namespace RTT::corba::detail
