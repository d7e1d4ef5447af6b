// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/SentCall.hpp>

#include <rtt/ExecutionEngine.hpp>
#include <rtt/Logger.hpp>
#include <rtt/base/OperationCallerInterface.hpp>
#include <rtt/internal/GlobalEngine.hpp>

#include <exception>

namespace RTT {

SendError::SendError(SendStatus status, const std::string& why) : std::runtime_error(why), status_(status) {}

namespace internal {

SentCall::SentCall() = default;
SentCall::~SentCall() = default;

void SentCall::setEngines(ExecutionEngine* caller, ExecutionEngine* executor) {
    caller_ = caller;
    executor_ = executor;
    if (caller) wait_point_ = caller->waitPoint();
}

void SentCall::finish(State state) {
    // After the state is stored the caller may be gone, with its engine; the wait point is ours too.
    const std::shared_ptr<WaitPoint> waitPoint = wait_point_;
    state_.store(state);
    if (waitPoint) waitPoint->notify();
    deref();
}

void SentCall::executeAndDispose() {
    State state = Done;
    try {
        run();
    } catch (const std::exception& e) {
        log(Error) << "an operation threw: " << e.what() << endlog();
        state = Threw;
    } catch (...) {
        log(Error) << "an operation threw something that is no std::exception" << endlog();
        state = Threw;
    }
    // The component is in its new state before the caller learns of it.
    if (state == Threw && executor_) executor_->setExceptionTask();
    finish(state);
}

void SentCall::dispose() { finish(Disposed); }

SendStatus SentCall::status() const {
    switch (state()) {
        case Waiting: return SendNotReady;
        case Done: return SendSuccess;
        case Threw: return SendSuccess;
        case Disposed: return SendFailure;
    }
    return SendFailure;
}

SendStatus SentCall::collect() {
    if (!caller_) {
        if (state() == Waiting) {
            log(Error) << "an operation is collected by somebody who is no component: set the caller's engine "
                          "(this->engine() in a component, GlobalEngine::Instance() elsewhere)"
                       << endlog();
            return CollectFailure;
        }
    } else {
        caller_->waitForMessages([this] { return state() != Waiting; });
    }
    checkError();
    return status();
}

SendStatus SentCall::collectIfDone() const {
    checkError();
    return status();
}

void SentCall::checkError() const {
    if (state() == Threw)
        throw std::runtime_error(
            "the operation did not complete: it threw an exception, which its component has logged");
}

void SentCall::deref() {
    if (references_.fetch_sub(1, std::memory_order_acq_rel) == 1) delete this;
}

}  // namespace internal

namespace base {

OperationCallerInterface::~OperationCallerInterface() = default;

bool OperationCallerInterface::isSend() const { return thread_ == OwnThread && owner_ && !owner_->isSelf(); }

bool OperationCallerInterface::enqueue(internal::SentCall& call) const {
    ExecutionEngine* executor = thread_ == OwnThread && owner_ ? owner_ : internal::GlobalEngine::Instance();
    call.setEngines(caller_, executor);
    call.ref();  // the queue's
    if (executor->process(&call)) return true;
    call.dispose();
    return false;
}

void OperationCallerInterface::enqueueAndWait(internal::SentCall& call) const {
    if (!caller_)
        throw SendError(CollectFailure,
                        "an operation that is executed in its component's thread was called without a caller: "
                        "set the caller's engine (this->engine() in a component, GlobalEngine::Instance() elsewhere)");
    if (!enqueue(call) || call.collect() == SendFailure)
        throw SendError(SendFailure,
                        "the component that provides the operation takes no calls: it is in FatalError, has no "
                        "activity, or too many calls are waiting");
}

}  // namespace base
}  // namespace RTT
