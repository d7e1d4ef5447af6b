// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/function/function_call.hpp>

#include <rtt/ExecutionEngine.hpp>
#include <rtt/Logger.hpp>
#include <rtt/base/ActivityInterface.hpp>
#include <rtt/base/OperationCallerInterface.hpp>
#include <rtt/base/TaskCore.hpp>
#include <rtt/internal/engine/interruption.hpp>
#include <rtt/internal/engine/other_order.hpp>
#include <rtt/os/fosi.h>
#include <rtt/scripting/detail/function/function_pool.hpp>
#include <rtt/scripting/detail/execute/log_diagnostics.hpp>

#include <diag/print.hpp>

#include <optional>
#include <stdexcept>

namespace RTT::scripting::detail {

using internal::EngineGate;
using internal::Interruption;
using Outcome = Process::Outcome;

namespace {

constexpr std::int64_t kMillisecond = 1000000;

bool isFatal(const ExecutionEngine& engine) {
    const base::TaskCore* const task = engine.getTaskCore();
    return task && task->base::TaskCore::inFatalError();
}

/** Why the component does not execute a function. */
std::string whyRefused(const EngineGate& gate) {
    const EngineGate::Visit visit(gate);
    if (!visit.engine()) return "the component was destroyed";
    if (isFatal(*visit.engine())) return "the component is in FatalError";
    return visit.activity() ? "too many messages are waiting for the component" : "the component has no activity";
}

void warnIfInactive(const FunctionOwner& owner) {
    const EngineGate::Visit visit(*owner.gate);
    if (visit.activity() && !visit.activity()->isActive())
        log(Warning) << "a call of " << owner.describe() << " waits until the activity of the component is started"
                     << endlog();
}

}  // namespace

FunctionCall::FunctionCall(std::shared_ptr<FunctionOwner> owner, std::unique_ptr<Activation> activation,
                           std::shared_ptr<const Peers> peers)
    : owner_(std::move(owner)),
      activation_(std::move(activation)),
      noResult_(activation_->result ? activation_->result->clone() : nullptr),
      process_(activation_->code) {
    process_.watch(std::move(peers));
}

FunctionCall::~FunctionCall() = default;

void intrusive_ptr_release(FunctionCall* call) {
    if (call->references_.fetch_sub(1, std::memory_order_acq_rel) == 1) FunctionPool::giveBack(call);
}

// -- The thread that calls ------------------------------------------------------------------------------------------

bool FunctionCall::begin(const std::vector<Source>& values) {
    State now = state_.load();
    // The engine may still have a call that was given up.
    if (now == Waiting || (now == Refused && !isUnused())) return false;
    if (!state_.compare_exchange_strong(now, Waiting)) return false;
    process_.restart();
    outcome_ = Outcome::Yielded;
    sent_ = false;
    for (std::size_t i = 0; i != values.size(); ++i) {
        if (arguments()[i]->assignValue(values[i]->getRawConstPointer())) continue;
        state_.store(Refused);
        throw std::runtime_error("argument " + std::to_string(i + 1) + " of " + owner_->describe() + " has no value");
    }
    if (result()) result()->assignValue(noResult_->getRawConstPointer());
    return true;
}

void FunctionCall::call(const EngineGate* caller) {
    bool begun = !isLost();
    if (begun) {
        const EngineGate::Stand here(owner_->gate.get());
        if (here)
            executeHere();
        else
            begun = enqueue(caller);
    }
    if (begun && state_.load() == Waiting) {
        warnIfInactive(*owner_);
        wait();
    }
    if (!begun) state_.store(Refused);
    if (state_.load() == Refused)
        throw SendError(SendFailure, owner_->describe() + " was not executed" + (begun ? " to its end: " : ": ") +
                                         whyRefused(*owner_->gate));
    checkFailure();
}

bool FunctionCall::send(const EngineGate* caller) {
    sent_ = true;
    return enqueue(caller);
}

bool FunctionCall::enqueue(const EngineGate* caller) {
    const EngineGate* const own = EngineGate::ofThisThread();
    waiting_ = own ? own : caller && caller->isSelf() ? caller : nullptr;
    intrusive_ptr_add_ref(this);  // the queue's
    if (ExecutionEngine::process(*owner_->gate, this)) return true;
    dispose();
    return false;
}

SendStatus FunctionCall::collect(bool wait) {
    if (wait && executing_ && owner_->gate->isStepping())
        throw std::runtime_error(owner_->describe() + " waits for its own caller, which collects it here");
    if (wait) this->wait();
    switch (state_.load()) {
        case Waiting: return SendNotReady;
        case Done: return SendSuccess;
        case Failed: checkFailure(); break;
        case Idle:
        case Refused: break;
    }
    return SendFailure;
}

void FunctionCall::wait() {
    const auto over = [this] { return state_.load() != Waiting; };
    const EngineGate* own = EngineGate::ofThisThread();
    if (!own && waiting_ && waiting_->isSelf()) own = waiting_.get();
    const Interruption* const interruption = own ? nullptr : Interruption::ofScript();
    while (!over()) {
        if (interruption && interruption->asked())
            throw internal::Interrupted("interrupted while waiting for " + owner_->describe() + ", which goes on");
        // finish() wakes the engine of the thread that sent, and threads without an engine. Nothing wakes this thread
        // if the owner is destroyed, or if another engine collects than the one that sent.
        const bool isWoken = !own || own == waiting_.get();
        const std::int64_t soon =
            rtos_get_time_ns() + (interruption ? Interruption::kLook : (isWoken ? 100 : 1) * kMillisecond);
        if (own) {
            own->engine()->waitForMessages(over, soon);
        } else {
            const std::uint32_t ticket = done_.ticket();
            if (!over() && !internal::OtherOrder::executedHere()) done_.wait(ticket, internal::OtherOrder::limit(soon));
        }
        State waiting = Waiting;
        if (isLost()) state_.compare_exchange_strong(waiting, Refused);
    }
}

/** True if it will not be executed any more. */
bool FunctionCall::isLost() const {
    const EngineGate::Visit visit(*owner_->gate);
    return !visit.engine() || isFatal(*visit.engine());
}

std::string FunctionCall::failure() const {
    const ast::Place place = process_.place();
    return owner_->describe() + " failed at " +
           oroforge::diag::toString(oroforge::diag::Location{owner_->file, place.line, place.column}) + ": " +
           process_.message();
}

void FunctionCall::reportFailure() const {
    oroforge::diag::Sink sink;
    process_.report(sink, owner_->file, owner_->describe());
    oroforge::diag::SourceCache lines;
    // Threads of components must not read files.
    const auto text = owner_->text.lock();
    lines.add(owner_->file, text && process_.failedCall() ? *text : "");
    logDiagnostics(sink, lines);
}

void FunctionCall::checkFailure() const {
    if (state_.load() != Failed) return;
    if (!process_.failedCall()) throw std::runtime_error(failure());
    FailedCall failed = *process_.failedCall();
    const auto text = owner_->text.lock();
    failed.isFrom(owner_->file, text ? *text : "");
    failed.leaves(owner_->describe() + " is called here");
    throw failed;
}

// -- The thread that executes ---------------------------------------------------------------------------------------

/** Executes until the end or a `yield`; true at the end. */
bool FunctionCall::executePart() {
    executing_ = true;
    process_.setRoundLimit(owner_->roundLimit ? owner_->roundLimit->rvalue() : 0);
    outcome_ = process_.run();
    executing_ = false;
    return outcome_ != Outcome::Yielded;
}

/** Executes the function in the calling thread, which is that of the owner. */
void FunctionCall::executeHere() {
    std::optional<Interruption::Listener> listener;
    if (Interruption::ofScript()) listener.emplace([this] { process_.pause(); });
    while (!executePart()) {
        if (isLost()) return state_.store(Refused);
        if (!owner_->warned.exchange(true))
            log(Warning) << owner_->describe()
                         << " yields in a call by the component itself, which executes nothing but "
                         << "messages until it is done (next is line " << process_.line() << ")" << endlog();
        serveMessages();
    }
    const bool interrupted = outcome_ == Outcome::Paused || process_.interrupted();
    state_.store(interrupted ? Refused : outcome_ == Outcome::Failed ? Failed : Done);
    if (interrupted) throw internal::Interrupted(owner_->describe() + " was interrupted");
}

/** Executes messages for a while, as between two steps of the component. */
void FunctionCall::serveMessages() {
    owner_->gate->engine()->waitForMessages([] { return false; }, rtos_get_time_ns() + kMillisecond);
}

void FunctionCall::executeAndDispose() {
    const shared_ptr queued(this, false);
    if (executePart()) return settle();
    // Steps of the component execute the rest. The engine owns the reference.
    listed_ = true;
    intrusive_ptr_add_ref(this);
    ExecutionEngine* const engine = owner_->gate->engine();
    if (engine && engine->runFunction(this)) return goOn();
    if (!listed_) return;  // already finished
    listed_ = false;
    const shared_ptr refused(this, false);
    settle();
}

bool FunctionCall::execute() {
    // A call inside the function waits, and the component executes other functions meanwhile, but not this one.
    if (executing_) return true;
    const shared_ptr alive(this);
    if (executePart()) return false;
    goOn();
    return true;
}

/** Asks for a next step if nothing else does. */
void FunctionCall::goOn() {
    ExecutionEngine* const engine = owner_->gate->engine();
    base::ActivityInterface* const activity = engine ? engine->getActivity() : nullptr;
    if (!activity || activity->getPeriod() > 0) return;
    if (!owner_->warned.exchange(true))
        log(Warning) << owner_->describe()
                     << " yields, and the component has no period: it makes one step after the other "
                     << "until the function is done (next is line " << process_.line() << ")" << endlog();
    activity->timeout();
}

void FunctionCall::unloaded() {
    base::ExecutableInterface::unloaded();
    if (!listed_) return;
    listed_ = false;
    const shared_ptr executed(this, false);
    settle();
}

void FunctionCall::dispose() {
    const shared_ptr queued(this, false);
    settle();
}

/** Fails the call if it has not ended, because the rest will not be executed. */
void FunctionCall::settle() {
    finish(outcome_ == Outcome::Yielded ? Refused : outcome_ == Outcome::Failed ? Failed : Done);
}

void FunctionCall::finish(State state) {
    // As soon as the other thread sees the state, it may begin a new call.
    const boost::intrusive_ptr<const EngineGate> waiting = waiting_;
    if (state == Failed && sent_) reportFailure();
    State now = Waiting;
    state_.compare_exchange_strong(now, state);
    done_.notify();
    if (waiting) waiting->waitPoint.notify();
}

}  // namespace RTT::scripting::detail
