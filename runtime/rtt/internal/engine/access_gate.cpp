// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/engine/access_gate.hpp>

#include <rtt/os/futex.hpp>

namespace RTT::internal {

void AccessGate::close() noexcept {
    closed_ = true;
    if (!shared_) return;
    Presence::Waiter(this).wait(os::detail::kForever);
}

void AccessGate::closeForGood() noexcept {
    close();
    Presence::forget(this);
}

}  // namespace RTT::internal
