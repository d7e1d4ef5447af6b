// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/engine/other_order.hpp>

#include <rtt/os/fosi.h>

#include <algorithm>
#include <atomic>

namespace RTT::internal {

namespace {
std::atomic<OtherOrder*> present{nullptr};
constexpr std::int64_t kMillisecond = 1000000;
}  // namespace

thread_local OtherOrder* OtherOrder::ofThisThread_ = nullptr;

OtherOrder::~OtherOrder() = default;

void OtherOrder::install(OtherOrder* order) noexcept {
    present = order;
    ofThisThread_ = order;
}

OtherOrder* OtherOrder::installed() noexcept { return present.load(std::memory_order_acquire); }

std::int64_t OtherOrder::soon(std::int64_t deadline) {
    return std::min<std::int64_t>(deadline, rtos_get_time_ns() + kMillisecond);
}

}  // namespace RTT::internal
