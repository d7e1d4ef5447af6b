// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/calls/callee.hpp>

#include <rtt/base/OperationBase.hpp>
#include <rtt/internal/SignalBase.hpp>

namespace RTT::internal {

CalleeBase::~CalleeBase() = default;

void CalleeBase::deref() const {
    if (references_.fetch_sub(1, std::memory_order_acq_rel) == 1) delete this;
}

void CalleeBase::listen(std::shared_ptr<SignalBase> signal) {
    signal_ = std::move(signal);
    // Release: a thread that calls sees the complete signal.
    listeners_.store(signal_.get(), std::memory_order_release);
}

void CalleeBase::listenLike(const CalleeBase* other) {
    if (other && other->signal_ && !signal_) listen(other->signal_);
}

void CalleeBase::belongsTo(std::shared_ptr<const base::OperationDescription> operation) {
    operation_ = std::move(operation);
}

std::string CalleeBase::operationName() const { return operation_ ? operation_->name : std::string(); }

std::string describe(const CalleeBase* callee) {
    const std::string name = callee ? callee->operationName() : std::string();
    return name.empty() ? "an operation" : "operation '" + name + "'";
}

void CalleeBase::emit(const SignalBase& signal, void* const* arguments) { signal.emitErased(arguments); }

}  // namespace RTT::internal
