// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/engine/other_order.hpp>

#include <rtt/os/fosi.h>

#include <algorithm>
#include <atomic>

namespace RTT::internal {

namespace {
std::atomic<OtherOrder*> present{nullptr};
thread_local OtherOrder* ofThisThread __attribute__((tls_model("initial-exec"))) = nullptr;
constexpr std::int64_t kMillisecond = 1000000;
}  // namespace

OtherOrder::~OtherOrder() = default;

void OtherOrder::install(OtherOrder* order) noexcept {
    present = order;
    ofThisThread = order;
}

OtherOrder* OtherOrder::installed() noexcept { return present.load(std::memory_order_acquire); }

bool OtherOrder::executedHere() { return ofThisThread && ofThisThread->executeOne(); }

std::int64_t OtherOrder::limit(std::int64_t deadline) {
    return ofThisThread ? std::min<std::int64_t>(deadline, rtos_get_time_ns() + kMillisecond) : deadline;
}

}  // namespace RTT::internal
