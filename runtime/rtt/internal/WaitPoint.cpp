// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/WaitPoint.hpp>

#include <rtt/os/detail/futex.hpp>

namespace RTT {
namespace internal {

void WaitPoint::wait(std::uint32_t ticket) {
    while (epoch_.load() == ticket) os::detail::futexWait(epoch_, ticket, os::detail::kForever);
    waiters_.fetch_sub(1);
}

void WaitPoint::wake() { os::detail::futexWakeAll(epoch_); }

}  // namespace internal
}  // namespace RTT
