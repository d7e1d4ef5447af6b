// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/engine/interruption.hpp>

#include <utility>

namespace RTT::internal {

namespace {

thread_local Interruption* innermost __attribute__((tls_model("initial-exec"))) = nullptr;

}  // namespace

Interrupted::~Interrupted() = default;

Interruption::Interruption(bool patient) : outer_(innermost), patient_(patient) { innermost = this; }

Interruption::~Interruption() { innermost = outer_; }

Interruption* Interruption::ofThisThread() noexcept { return innermost; }

const Interruption* Interruption::ofScript() noexcept {
    return innermost && innermost->region_ == Region::Script ? innermost : nullptr;
}

void Interruption::ask() {
    const std::lock_guard<std::mutex> locked(mutex_);
    asked_.store(true, std::memory_order_release);
    for (const Listener* listener = listeners_; listener; listener = listener->outer_) listener->told_();
}

Interruption::Listener::Listener(std::function<void()> told)
    : of_(innermost), told_(std::move(told)), outer_(of_ ? of_->listeners_ : nullptr) {
    if (!of_) return;
    const std::lock_guard<std::mutex> locked(of_->mutex_);
    of_->listeners_ = this;
    if (of_->asked()) told_();
}

Interruption::Listener::~Listener() {
    if (!of_) return;
    const std::lock_guard<std::mutex> locked(of_->mutex_);
    of_->listeners_ = outer_;
}

}  // namespace RTT::internal
