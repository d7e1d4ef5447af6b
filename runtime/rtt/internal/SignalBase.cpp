// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/SignalBase.hpp>

#include <rtt/Handle.hpp>
#include <rtt/internal/flow/reclaimer.hpp>

#include <algorithm>

namespace RTT {
namespace internal {

/** The functions to call, in order of connection. The signal and emitting threads refer to it. */
struct SignalBase::List {
    std::vector<ConnectionPtr> connections;
    mutable std::atomic<int> references{1};
};

void intrusive_ptr_add_ref(const SignalBase::List* list) { list->references.fetch_add(1, std::memory_order_relaxed); }
void intrusive_ptr_release(const SignalBase::List* list) {
    if (list->references.fetch_sub(1, std::memory_order_acq_rel) == 1) delete list;
}

SignalBase::Connection::~Connection() = default;

bool SignalBase::Connection::connect() {
    {
        std::lock_guard<std::mutex> lock(mutex_);
        if (!signal_ || connected_) return false;
        connected_.store(true, std::memory_order_release);
        signal_->change(shared_from_this(), true);
    }
    Reclaimer::collect();
    return true;
}

bool SignalBase::Connection::disconnect() {
    {
        std::lock_guard<std::mutex> lock(mutex_);
        if (!signal_ || !connected_) return false;
        connected_.store(false, std::memory_order_release);
        signal_->change(shared_from_this(), false);
    }
    Reclaimer::collect();
    return true;
}

void SignalBase::Connection::orphan() {
    std::lock_guard<std::mutex> lock(mutex_);
    connected_.store(false, std::memory_order_release);
    signal_ = nullptr;
}

SignalBase::~SignalBase() {
    for (const std::weak_ptr<Connection>& made : made_)
        if (const ConnectionPtr connection = made.lock()) connection->orphan();
    if (const List* last = connected_) intrusive_ptr_release(last);
}

void SignalBase::add(const ConnectionPtr& connection, bool connect) {
    {
        std::lock_guard<std::mutex> lock(mutex_);
        made_.erase(std::remove_if(made_.begin(), made_.end(), [](const auto& made) { return made.expired(); }),
                    made_.end());
        made_.push_back(connection);
    }
    connection->signal_ = this;
    if (connect) connection->connect();
}

// Counted, not guarded while in use: called functions may take long, and may connect and disconnect.
boost::intrusive_ptr<const SignalBase::List> SignalBase::snapshot() const {
    if (!connected_.load(std::memory_order_relaxed)) return nullptr;
    const Reclaimer::Guard guard;
    return connected_.load(std::memory_order_acquire);
}

void SignalBase::emitErased(void* const* arguments) const {
    const boost::intrusive_ptr<const List> all = snapshot();
    if (!all) return;
    for (const ConnectionPtr& connection : all->connections)
        if (connection->connected()) connection->call(arguments);
}

void SignalBase::change(const ConnectionPtr& connection, bool present) {
    std::lock_guard<std::mutex> lock(mutex_);
    const List* const previous = connected_.load(std::memory_order_relaxed);
    auto next = std::make_unique<List>();
    if (previous)
        for (const ConnectionPtr& other : previous->connections)
            if (other != connection) next->connections.push_back(other);
    if (present) next->connections.push_back(connection);
    // Release: an emitting thread sees the content of the list.
    connected_.store(next->connections.empty() ? nullptr : next.release(), std::memory_order_release);
    // The signal drops its own reference when no thread can be about to take another one.
    if (previous)
        Reclaimer::retire(const_cast<List*>(previous),
                          [](void* list) { intrusive_ptr_release(static_cast<const List*>(list)); });
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
