// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "housekeeper.hpp"

#include <rtt/ExecutionEngine.hpp>
#include <rtt/internal/GlobalEngine.hpp>

namespace OCL::chain {

void Housekeeper::request() {
    if (queued_.exchange(true, std::memory_order_acq_rel)) return;
    owners_.fetch_add(1, std::memory_order_relaxed);
    if (!RTT::internal::GlobalEngine::Instance()->process(this)) dispose();
}

void Housekeeper::dismiss() {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        chain_ = nullptr;
    }
    release();
}

void Housekeeper::executeAndDispose() {
    queued_.exchange(false, std::memory_order_acq_rel);  // before the work: a later request leads to another one
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (chain_) work_(chain_);
    }
    release();
}

void Housekeeper::dispose() {
    queued_.exchange(false, std::memory_order_acq_rel);
    release();
}

void Housekeeper::release() {
    if (owners_.fetch_sub(1, std::memory_order_acq_rel) == 1) delete this;
}

}  // namespace OCL::chain
