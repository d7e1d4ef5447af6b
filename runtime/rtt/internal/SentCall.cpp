// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/SentCall.hpp>

#include <rtt/ExecutionEngine.hpp>
#include <rtt/Logger.hpp>
#include <rtt/base/ActivityInterface.hpp>
#include <rtt/base/OperationCallerInterface.hpp>
#include <rtt/base/TaskCore.hpp>
#include <rtt/internal/EngineGate.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/os/detail/futex.hpp>

#include <exception>

namespace RTT {

SendError::SendError(SendStatus status, const std::string& why) : std::runtime_error(why), status_(status) {}

namespace internal {

SentCall::SentCall(CalleeBase* callee) : callee_(callee) {}
SentCall::~SentCall() = default;

// It is the thread that waits, so what counts is the engine it executes: it may be executing an operation of the caller
// for a third component, which others then call.
void SentCall::setEngines(ExecutionEngine* caller, ExecutionEngine* executor) {
    executor_ = executor;
    if (!caller) return;
    const EngineGate* const own = EngineGate::ofThisThread();
    waiting_ = own ? own : caller->gate().get();
}

void SentCall::finish(State state) {
    // After the state is stored the caller may be gone, with its engine; the gate, and this, are ours until deref().
    if (state_.exchange(state) & kParked) os::detail::futexWakeAll(state_);
    if (waiting_) waiting_->waitPoint.notify();
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
    if (state() == Waiting) {
        if (!waiting_) {
            log(Error) << "an operation is collected by somebody who is no component: set the caller's engine "
                          "(this->engine() in a component, GlobalEngine::Instance() elsewhere)"
                       << endlog();
            return CollectFailure;
        }
        const auto done = [this] { return state() != Waiting; };
        const EngineGate* const own = EngineGate::ofThisThread();
        if (own && own != waiting_.get()) {
            // Sent by another component, so nobody will tell this thread's engine of the end: it looks at the call as well.
            std::uint32_t waiting = Waiting;
            state_.compare_exchange_strong(waiting, Waiting | kParked);
            own->engine()->waitForMessages(done, os::detail::kForever, &state_);
        } else if (own || waiting_->isSelf()) {
            waiting_->engine()->waitForMessages(done);
        } else {
            park();
        }
    }
    checkError();
    return status();
}

// On the call itself: many threads that are no components may wait, each for its own, and none shall wake the others.
void SentCall::park() {
    std::uint32_t seen = state_.load(std::memory_order_acquire);
    while ((seen & ~kParked) == Waiting) {
        if (!(seen & kParked) && !state_.compare_exchange_weak(seen, seen | kParked)) continue;
        os::detail::futexWait(state_, Waiting | kParked, os::detail::kForever);
        seen = state_.load(std::memory_order_acquire);
    }
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

OperationCallerInterface::OperationCallerInterface(const OperationCallerInterface& other, ExecutionEngine* caller)
    : thread_(other.thread_), callee_(other.callee_), owner_(other.owner_), caller_(caller) {}

bool OperationCallerInterface::ready() const { return callee_ && !isGone(); }

void OperationCallerInterface::setCallee(internal::CalleeBase* callee) { callee_ = callee; }

void OperationCallerInterface::setThread(ExecutionThread et, ExecutionEngine* owner) {
    thread_ = et;
    owner_ = owner ? owner->gate() : nullptr;
}

bool OperationCallerInterface::isSend() const { return thread_ == OwnThread && owner_ && !owner_->isSelf(); }

bool OperationCallerInterface::enqueue(internal::SentCall& call) const {
    const internal::EngineGate& gate =
        thread_ == OwnThread && owner_ ? *owner_ : *internal::GlobalEngine::Instance()->gate();
    call.setEngines(caller_, gate.engine());
    call.ref();  // the queue's
    if (ExecutionEngine::process(gate, &call)) return true;
    call.dispose();
    return false;
}

internal::SentCall* OperationCallerInterface::enqueueNew(internal::SentCall* call) const {
    internal::SentCall::shared_ptr held(call);
    return enqueue(*call) ? held.detach() : nullptr;
}

namespace {

// No virtual functions here: the sub-class of a component may be under destruction, its engine and its TaskCore are not.

/** The component that provides an operation, and what keeps it from executing calls; for messages. */
std::string whyRefused(const internal::EngineGate& gate) {
    const internal::EngineGate::Visit visit(gate);
    if (!visit.engine()) return "the component that provides it was destroyed";
    const TaskCore* const task = visit.engine()->getTaskCore();
    const std::string who = task ? "component '" + task->TaskCore::getName() + "'" : std::string("the GlobalEngine");
    if (task && task->TaskCore::inFatalError()) return who + " is in FatalError";
    if (!visit.activity()) return who + " has no activity";
    return "too many messages are waiting for " + who;
}

void warnIfInactive(const internal::EngineGate& gate) {
    const internal::EngineGate::Visit visit(gate);
    if (!visit.activity() || visit.activity()->isActive() || !visit.engine()->getTaskCore()) return;
    log(Warning) << "a call waits until the activity of component '"
                 << visit.engine()->getTaskCore()->TaskCore::getName() << "' is started, which is to execute it"
                 << endlog();
}

}  // namespace

void OperationCallerInterface::enqueueAndWait(internal::SentCall& call) const {
    if (!caller_)
        throw SendError(CollectFailure,
                        "an operation that is executed in its component's thread was called without a caller: "
                        "set the caller's engine (this->engine() in a component, GlobalEngine::Instance() elsewhere)");
    const bool accepted = enqueue(call);
    if (accepted && call.state() == internal::SentCall::Waiting) warnIfInactive(*owner_);
    if (!accepted || call.collect() == SendFailure)
        throw SendError(SendFailure, "an operation was not executed: " + whyRefused(*owner_));
}

}  // namespace base
}  // namespace RTT
