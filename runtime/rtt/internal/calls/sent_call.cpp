// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/calls/sent_call.hpp>

#include <rtt/ExecutionEngine.hpp>
#include <rtt/Logger.hpp>
#include <rtt/base/ActivityInterface.hpp>
#include <rtt/base/OperationCallerInterface.hpp>
#include <rtt/base/TaskCore.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/internal/calls/failure_report.hpp>
#include <rtt/internal/calls/sending.hpp>
#include <rtt/internal/engine/engine_gate.hpp>
#include <rtt/internal/engine/interruption.hpp>
#include <rtt/internal/engine/other_order.hpp>
#include <rtt/os/MainThread.hpp>
#include <rtt/os/fosi.h>
#include <rtt/os/futex.hpp>

#include <exception>
#include <new>
#include <optional>
#include <stdexcept>

namespace RTT {

SendError::SendError(SendStatus status, const std::string& why) : std::runtime_error(why), status_(status) {}

namespace internal {

SentCall::SentCall(CalleeBase* callee) : callee_(callee) {}
SentCall::~SentCall() = default;
RemoteCollect::~RemoteCollect() = default;

void SentCall::run() {}
void SentCall::collectFrom(std::unique_ptr<RemoteCollect> remote) { remote_ = std::move(remote); }

bool SentCall::beginAgain() {
    if (references_.load(std::memory_order_acquire) != 1) return false;
    state_.store(Waiting, std::memory_order_relaxed);
    error_.reset();
    return true;
}

// The thread waits, so the engine that it executes counts, not that of `caller`: it may be executing an operation of
// the caller on behalf of a third component, which other threads call meanwhile.
void SentCall::setEngines(ExecutionEngine* caller, ExecutionEngine* executor) {
    executor_ = executor;
    if (!caller) return;
    const EngineGate* const own = EngineGate::ofThisThread();
    waiting_ = own ? own : caller->gate().get();
}

void SentCall::setProvider(const boost::intrusive_ptr<const EngineGate>& provider, bool blamed) {
    provider_ = provider;
    blamed_ = blamed;
}

void SentCall::finish(State state) {
    // Once the state is stored the caller and its engine may be gone; the gate and this object stay until deref().
    if (state_.exchange(state) & kParked) os::detail::futexWakeAll(state_);
    if (waiting_) waiting_->waitPoint.notify();
    deref();
}

void SentCall::executeAndDispose() {
    // This thread's script did not call this: it serves other components while it waits.
    const Interruption::Region foreign(Interruption::ofThisThread(), Interruption::Region::Native);
    const FailureReport::Pause others;
    const boost::intrusive_ptr<const EngineGate> provider = provider_;
    std::optional<EngineGate::Visit> visit;
    // A thread that destroys the component and executes messages meanwhile must not run it either.
    if (provider && (visit.emplace(*provider), provider->retired())) return dispose();
    try {
        run();
    } catch (const std::exception& e) {
        return threw(e.what());
    } catch (...) {
        return threw("something that is no std::exception");
    }
    finish(Done);
}

void SentCall::threw(const char* what) {
    try {
        const base::TaskCore* const task = executor_ ? executor_->getTaskCore() : nullptr;
        error_ = std::make_unique<std::string>(
            describe(callee()) + " threw in " +
            (task ? "component '" + task->base::TaskCore::getName() + "'" : std::string("the GlobalEngine")) + ": " +
            what);
        if (!blamed_) log(Error) << *error_ << endlog();
    } catch (const std::exception&) {
        // No memory for the text; the state still says that it threw.
    }
    // The component enters its new state before the caller learns of the exception.
    if (executor_) executor_->enterException();
    if (blamed_ && provider_) blame(*provider_, callee(), what);
    finish(Threw);
}

void SentCall::dispose() { finish(Disposed); }

namespace {

constexpr std::int64_t kPatience = 100000000;  // in ns

/** Takes an exception, thrown in another thread, to the engine of the operation's component. */
class Thrown final : public SentCall {
public:
    Thrown(CalleeBase* callee, const char* what) : SentCall(callee), what_(what) {}
    const void* resultAddress() const override { return nullptr; }
    void* argumentAddress(unsigned) override { return nullptr; }

private:
    void run() override {
        // Another exception may have arrived first.
        const base::TaskCore* const task = executor() ? executor()->getTaskCore() : nullptr;
        if (!task || !task->base::TaskCore::inException()) throw std::runtime_error(what_);
    }
    const std::string what_;
};

/** False if the engine of the component has to execute it. */
bool executedHere(const EngineGate& owner, SentCall& thrown) {
    const EngineGate::Visit visit(owner);
    ExecutionEngine* const engine = visit.engine();
    const base::TaskCore* const task = engine ? engine->getTaskCore() : nullptr;
    if (!task || task->base::TaskCore::inException()) return true;
    thrown.setEngines(nullptr, engine);
    const EngineGate::Stand here(&owner);
    const bool active = visit.activity() && visit.activity()->isActive();
    thrown.ref();  // given to the engine, or to executeAndDispose()
    if (!here && active && ExecutionEngine::process(owner, &thrown)) return false;
    thrown.executeAndDispose();
    return true;
}

}  // namespace

void blame(const EngineGate& owner, CalleeBase* callee, const char* what) {
    try {
        const SentCall::shared_ptr thrown(new Thrown(callee, what));
        if (!executedHere(owner, *thrown)) (void)thrown->endsBefore(rtos_get_time_ns() + kPatience);
    } catch (const std::bad_alloc&) {
        // The caller learns of the exception anyway.
    }
}

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
    if (remote_) return remote_->collect(true);
    if (state() == Waiting) {
        if (!waiting_) {
            log(Error) << describe(callee())
                       << " is collected by code outside of a component: set the caller's engine "
                          "(this->engine() in a component, GlobalEngine::Instance() elsewhere)"
                       << endlog();
            return CollectFailure;
        }
        const EngineGate* const own = EngineGate::ofThisThread();
        if (own && own != waiting_.get()) {
            // Another component sent it, so the end does not notify this thread's engine.
            (void)endsBefore(os::detail::kForever);
        } else if (own || waiting_->isSelf()) {
            waiting_->engine()->waitForMessages([this] { return state() != Waiting; });
        } else {
            park();
        }
    }
    checkError();
    return status();
}

bool SentCall::endsBefore(std::int64_t deadline) {
    for (;;) {
        std::uint32_t seen = Waiting;
        if (!state_.compare_exchange_strong(seen, Waiting | kParked) && seen != (Waiting | kParked)) return true;
        EngineGate::sleepOn(state_, Waiting | kParked, deadline);
        if (state() == Waiting && deadline != os::detail::kForever && rtos_get_time_ns() >= deadline) return false;
    }
}

// Waits on the call itself, so that threads that execute no component do not wake each other.
void SentCall::park() {
    const Interruption* const interruption = Interruption::ofScript();
    // The main thread may wait for a component on whose behalf it calls. If the component's activity ends meanwhile,
    // main has to execute the call itself, and nothing wakes it for that.
    const bool mayStand = waiting_->engine() == executor_ && os::MainThread::Instance()->isSelf();
    std::uint32_t seen = state_.load(std::memory_order_acquire);
    while ((seen & ~kParked) == Waiting) {
        if (!(seen & kParked) && !state_.compare_exchange_weak(seen, seen | kParked)) continue;
        if (OtherOrder::executedHere()) {
            // It may have been what this thread waits for.
        } else if (!interruption && !mayStand)
            os::detail::futexWait(state_, Waiting | kParked, OtherOrder::limit(os::detail::kForever));
        else if (mayStand && waiting_->isSelf())
            return waiting_->engine()->waitForMessages([this] { return state() != Waiting; });
        else if (interruption && interruption->asked())
            throw Interrupted("interrupted while waiting for " + describe(callee()) +
                              ", which goes on in its component");
        else
            os::detail::futexWait(state_, Waiting | kParked, rtos_get_time_ns() + Interruption::kLook);
        seen = state_.load(std::memory_order_acquire);
    }
}

SendStatus SentCall::collectIfDone() {
    if (remote_) return remote_->collect(false);
    checkError();
    return status();
}

void SentCall::checkError() const {
    if (state() == Threw)
        throw std::runtime_error(error_ ? error_->c_str() : "an operation threw in its component's thread");
}

void SentCall::deref() {
    if (references_.fetch_sub(1, std::memory_order_acq_rel) == 1) delete this;
}

}  // namespace internal

namespace base {

OperationCallerInterface::~OperationCallerInterface() = default;

OperationCallerInterface::OperationCallerInterface(const OperationCallerInterface& other, ExecutionEngine* caller)
    : thread_(other.thread_), callee_(other.callee_), owner_(other.owner_), caller_(caller) {}

void OperationCallerInterface::setCallee(internal::CalleeBase* callee) { callee_ = callee; }

void OperationCallerInterface::setThread(ExecutionThread et, ExecutionEngine* owner) {
    thread_ = et;
    owner_ = owner ? owner->gate() : nullptr;
}

bool OperationCallerInterface::isSend() const { return thread_ == OwnThread && owner_ && !owner_->isSelf(); }

void OperationCallerInterface::ownerThrew(const char* what) const {
    if (owner_ && callee_) internal::blame(*owner_, callee(), what);
}

bool OperationCallerInterface::enqueue(internal::SentCall& call) const {
    const internal::EngineGate& gate =
        thread_ == OwnThread && owner_ ? *owner_ : *internal::GlobalEngine::Instance()->gate();
    call.setEngines(caller_, gate.engine());
    if (owner_ && owner_.get() != &gate) call.setProvider(owner_, generic_);
    call.ref();  // for the queue
    DisposableInterface* queued = &call;
    if (internal::Sending::Watcher* const watcher = internal::Sending::take(callee())) queued = watcher->queued(call);
    if (ExecutionEngine::process(gate, queued)) return true;
    queued->dispose();
    return false;
}

internal::SentCall* OperationCallerInterface::enqueueNew(internal::SentCall* call) const {
    internal::SentCall::shared_ptr held(call);
    return enqueue(*call) ? held.detach() : nullptr;
}

namespace {

// No virtual calls here: a component's subclass may be under destruction, but its engine and its TaskCore exist.

/** Names the component that provides an operation, and what keeps it from executing calls. */
std::string whyRefused(const internal::EngineGate& gate) {
    const internal::EngineGate::Visit visit(gate);
    ExecutionEngine* const engine = visit.engine();  // read once: later it may be null
    if (!engine) return "the component that provides it was destroyed";
    const TaskCore* const task = engine->getTaskCore();
    const std::string who = task ? "component '" + task->TaskCore::getName() + "'" : std::string("the GlobalEngine");
    if (task && task->TaskCore::inFatalError()) return who + " is in FatalError";
    if (!visit.activity()) return who + " has no activity";
    return "too many messages are waiting for " + who;
}

void warnIfInactive(const internal::EngineGate& gate) {
    const internal::EngineGate::Visit visit(gate);
    base::ActivityInterface* const activity = visit.activity();
    ExecutionEngine* const engine = visit.engine();  // read once: later it may be null
    if (!activity || activity->isActive() || !engine || !engine->getTaskCore()) return;
    log(Warning) << "a call waits until the activity of component '" << engine->getTaskCore()->TaskCore::getName()
                 << "' is started, which is to execute it" << endlog();
}

}  // namespace

void OperationCallerInterface::enqueueAndWait(internal::SentCall& call) const {
    if (!caller_)
        throw SendError(CollectFailure,
                        internal::describe(callee()) +
                            ", which is executed in its component's thread, was called without a caller: set the "
                            "caller's engine (this->engine() in a component, GlobalEngine::Instance() elsewhere)");
    // `this` may be gone afterwards: a message that is executed meanwhile may bind the caller to another operation.
    const boost::intrusive_ptr<const internal::EngineGate> owner = owner_;
    const boost::intrusive_ptr<internal::CalleeBase> function = callee_;
    const bool accepted = enqueue(call);
    if (accepted && call.state() == internal::SentCall::Waiting) warnIfInactive(*owner);
    if (!accepted || call.collect() == SendFailure)
        throw SendError(SendFailure, internal::describe(function.get()) + " was not executed: " + whyRefused(*owner));
}

}  // namespace base
}  // namespace RTT
