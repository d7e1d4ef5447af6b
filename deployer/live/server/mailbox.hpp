// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_MAILBOX_HPP
#define OROFORGE_LIVE_MAILBOX_HPP

#include "transport.hpp"

#include <functional>
#include <mutex>

namespace OCL::live {

/** Brings functions from any thread to that of the transport, until it is closed; then it drops them. */
class Mailbox {
public:
    explicit Mailbox(Transport& transport) : transport_(&transport) {}
    void put(std::function<void()> function) {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (transport_) transport_->post(std::move(function));
    }
    void close() {
        const std::lock_guard<std::mutex> lock(mutex_);
        transport_ = nullptr;
    }

private:
    std::mutex mutex_;
    Transport* transport_;
};

}  // namespace OCL::live

#endif
