// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/SignalBase.hpp>

#include <rtt/Handle.hpp>

#include <algorithm>

namespace RTT {
namespace internal {

SignalBase::Connection::~Connection() = default;

bool SignalBase::Connection::connect() {
    std::lock_guard<std::mutex> lock(mutex_);
    if (!signal_ || connected_) return false;
    connected_.store(true, std::memory_order_release);
    signal_->change(shared_from_this(), true);
    return true;
}

bool SignalBase::Connection::disconnect() {
    std::lock_guard<std::mutex> lock(mutex_);
    if (!signal_ || !connected_) return false;
    connected_.store(false, std::memory_order_release);
    signal_->change(shared_from_this(), false);
    return true;
}

void SignalBase::Connection::orphan() {
    std::lock_guard<std::mutex> lock(mutex_);
    connected_.store(false, std::memory_order_release);
    signal_ = nullptr;
}

SignalBase::~SignalBase() {
    if (auto all = snapshot())
        for (const ConnectionPtr& connection : *all) connection->orphan();
}

void SignalBase::add(const ConnectionPtr& connection, bool connect) {
    connection->signal_ = this;
    if (connect) connection->connect();
}

std::shared_ptr<const SignalBase::Connections> SignalBase::snapshot() const {
    if (!any_.load(std::memory_order_acquire)) return nullptr;
    return std::atomic_load(&connections_);
}

void SignalBase::change(const ConnectionPtr& connection, bool present) {
    std::lock_guard<std::mutex> lock(mutex_);
    auto next = std::make_shared<Connections>();
    if (connections_)
        for (const ConnectionPtr& other : *connections_)
            if (other != connection) next->push_back(other);
    if (present) next->push_back(connection);
    any_.store(!next->empty(), std::memory_order_release);
    std::atomic_store(&connections_, std::shared_ptr<const Connections>(next));
}

}  // namespace internal

Handle::Handle(internal::SignalBase::ConnectionPtr connection) : connection_(std::move(connection)) {}
bool Handle::connect() { return connection_ && connection_->connect(); }
bool Handle::disconnect() { return connection_ && connection_->disconnect(); }
bool Handle::connected() const { return connection_ && connection_->connected(); }
bool Handle::ready() const { return connection_ != nullptr; }

ScopedHandle::ScopedHandle(const Handle& handle) : Handle(handle) {}
ScopedHandle::~ScopedHandle() { disconnect(); }

CleanupHandle::CleanupHandle(const Handle& handle) : Handle(handle) {}
CleanupHandle::~CleanupHandle() {
    disconnect();
    if (connection_) connection_->orphan();
}

}  // namespace RTT
