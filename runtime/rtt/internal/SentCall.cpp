// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/SentCall.hpp>

#include <rtt/ExecutionEngine.hpp>
#include <rtt/Logger.hpp>
#include <rtt/base/ActivityInterface.hpp>
#include <rtt/base/OperationCallerInterface.hpp>
#include <rtt/base/TaskCore.hpp>
#include <rtt/internal/EngineGate.hpp>
#include <rtt/internal/FailureReport.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/internal/Interruption.hpp>
#include <rtt/internal/Sending.hpp>
#include <rtt/os/MainThread.hpp>
#include <rtt/os/detail/futex.hpp>
#include <rtt/os/fosi.h>

#include <unistd.h>

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

// It is the thread that waits, so what counts is the engine it executes: it may be executing an operation of the caller
// for a third component, which others then call.
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
    // After the state is stored the caller may be gone, with its engine; the gate, and this, are ours until deref().
    if (state_.exchange(state) & kParked) os::detail::futexWakeAll(state_);
    if (waiting_) waiting_->waitPoint.notify();
    deref();
}

void SentCall::executeAndDispose() {
    // Not what the script of this thread called: it serves others while it waits.
    const Interruption::Region foreign(Interruption::ofThisThread(), Interruption::Region::Native);
    const FailureReport::Pause others;
    const boost::intrusive_ptr<const EngineGate> provider = provider_;
    std::optional<EngineGate::Visit> visit;
    // Nor by the thread that destroys the component, if that executes messages meanwhile.
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
        // No memory for the text. That it threw, the caller has to learn all the same.
    }
    // The component is in its new state before the caller learns of it.
    if (executor_) executor_->enterException();
    if (blamed_ && provider_) blame(*provider_, callee(), what);
    finish(Threw);
}

void SentCall::dispose() { finish(Disposed); }

namespace {

constexpr std::int64_t kPatience = 100000000, kLook = 1000000;  // in ns
constexpr unsigned kPause = 100;                                // in us, for a thread that executes no component

/** What an operation threw elsewhere, for the engine of its component. */
class Thrown final : public SentCall {
public:
    Thrown(CalleeBase* callee, const char* what) : SentCall(callee), what_(what) {}
    const void* resultAddress() const override { return nullptr; }
    void* argumentAddress(unsigned) override { return nullptr; }

private:
    void run() override {
        // Another one of these may have come first.
        const base::TaskCore* const task = executor() ? executor()->getTaskCore() : nullptr;
        if (!task || !task->base::TaskCore::inException()) throw std::runtime_error(what_);
    }
    const std::string what_;
};

/** False if the engine of the component has to do it. */
bool executedHere(const EngineGate& owner, SentCall& thrown) {
    const EngineGate::Visit visit(owner);
    ExecutionEngine* const engine = visit.engine();
    const base::TaskCore* const task = engine ? engine->getTaskCore() : nullptr;
    if (!task || task->base::TaskCore::inException()) return true;
    thrown.setEngines(nullptr, engine);
    const EngineGate::Stand here(&owner);
    const bool active = visit.activity() && visit.activity()->isActive();
    thrown.ref();  // taken by the engine, or by this thread
    if (!here && active && ExecutionEngine::process(owner, &thrown)) return false;
    thrown.executeAndDispose();
    return true;
}

}  // namespace

void blame(const EngineGate& owner, CalleeBase* callee, const char* what) {
    try {
        const SentCall::shared_ptr thrown(new Thrown(callee, what));
        if (executedHere(owner, *thrown)) return;
        const std::int64_t end = rtos_get_time_ns() + kPatience;
        const auto done = [&] { return thrown->state() != SentCall::Waiting; };
        const EngineGate* const own = EngineGate::ofThisThread();
        while (!done() && rtos_get_time_ns() < end) {
            if (own)
                own->engine()->waitForMessages(done, rtos_get_time_ns() + kLook);
            else
                usleep(kPause);
        }
    } catch (const std::bad_alloc&) {
        // The caller learns what the operation threw, all the same.
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
    const Interruption* const interruption = Interruption::ofScript();
    // Main may wait for a component in whose name it calls. If the component's activity ends meanwhile, main has to execute the
    // call itself, and nothing wakes it for that.
    const bool mayStand = waiting_->engine() == executor_ && os::MainThread::Instance()->isSelf();
    std::uint32_t seen = state_.load(std::memory_order_acquire);
    while ((seen & ~kParked) == Waiting) {
        if (!(seen & kParked) && !state_.compare_exchange_weak(seen, seen | kParked)) continue;
        if (!interruption && !mayStand)
            os::detail::futexWait(state_, Waiting | kParked, os::detail::kForever);
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
    call.ref();  // the queue's
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

// No virtual functions here: the sub-class of a component may be under destruction, its engine and its TaskCore are not.

/** The component that provides an operation, and what keeps it from executing calls; for messages. */
std::string whyRefused(const internal::EngineGate& gate) {
    const internal::EngineGate::Visit visit(gate);
    ExecutionEngine* const engine = visit.engine();  // asked again, it may be gone
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
    ExecutionEngine* const engine = visit.engine();  // asked again, it may be gone
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
    // This may be gone afterwards: the caller is bound to something else by a message that is executed while it waits.
    const boost::intrusive_ptr<const internal::EngineGate> owner = owner_;
    const boost::intrusive_ptr<internal::CalleeBase> function = callee_;
    const bool accepted = enqueue(call);
    if (accepted && call.state() == internal::SentCall::Waiting) warnIfInactive(*owner);
    if (!accepted || call.collect() == SendFailure)
        throw SendError(SendFailure, internal::describe(function.get()) + " was not executed: " + whyRefused(*owner));
}

}  // namespace base
}  // namespace RTT
