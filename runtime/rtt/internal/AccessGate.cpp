// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/AccessGate.hpp>

#include <rtt/os/detail/futex.hpp>

namespace RTT {
namespace internal {

namespace {
thread_local const AccessGate::Pass* innermost = nullptr;
}

bool AccessGate::enter() noexcept {
    if (!(word_.fetch_add(1) & kClosed)) return true;
    leave();
    return false;
}

void AccessGate::leave() noexcept {
    if (word_.fetch_sub(1) & kClosed) os::detail::futexWakeAll(word_);
}

void AccessGate::close() noexcept {
    std::uint32_t mine = 0;
    for (const Pass* pass = innermost; pass; pass = pass->outer_)
        if (pass->gate_.get() == this) ++mine;
    std::uint32_t word = word_.fetch_or(kClosed) | kClosed;
    while ((word & ~kClosed) > mine) {
        os::detail::futexWait(word_, word, os::detail::kForever);
        word = word_.load();
    }
}

AccessGate::Pass::Pass(const std::shared_ptr<AccessGate>& gate) noexcept {
    if (!gate || !gate->enter()) return;
    gate_ = gate;
    outer_ = innermost;
    innermost = this;
}

AccessGate::Pass::~Pass() {
    if (!gate_) return;
    innermost = outer_;
    gate_->leave();
}

}  // namespace internal
}  // namespace RTT
