// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The parts of a step. engine_queue.cpp has the requests of other threads.
#include <rtt/ExecutionEngine.hpp>

#include <rtt/Logger.hpp>
#include <rtt/base/ActivityInterface.hpp>
#include <rtt/base/TaskCore.hpp>
#include <rtt/internal/engine/detail/function_removal.hpp>
#include <rtt/internal/engine/detail/guarded_call.hpp>

#include <utility>

namespace RTT {

using internal::EngineGate;
using internal::Mailbox;
using internal::detail::guarded;

namespace {
/** Raises a flag, if there is one, until the end of the scope. */
class Raised {
public:
    explicit Raised(std::atomic<bool>* flag) noexcept : flag_(flag) {
        if (flag_) *flag_ = true;
    }
    ~Raised() {
        if (flag_) *flag_ = false;
    }
    Raised(const Raised&) = delete;
    Raised& operator=(const Raised&) = delete;

private:
    std::atomic<bool>* const flag_;
};
}  // namespace

ExecutionEngine::ExecutionEngine(base::TaskCore* owner)
    : gate_(new EngineGate(this)), task_(owner), functions_(owner) {}

ExecutionEngine::~ExecutionEngine() {
    const_cast<EngineGate&>(*gate_).close();  // from here on no thread puts anything into the queue
    disposeQueued();
}

void ExecutionEngine::setExceptionTask() {
    log(Error) << "in " << internal::detail::nameOf(task_) << ": a sent operation threw an exception" << endlog();
    enterException();
}

void ExecutionEngine::enterException() {
    if (task_) task_->exception();
}

void ExecutionEngine::setFatalTask() {
    // See accepts(): a thread that did not see the new state has queued its item before this.
    gate_->waitPoint.notify();
    const EngineGate::Visit visit(*gate_);
    if (base::ActivityInterface* activity = visit.activity()) activity->stop();
    disposeQueued();  // threads that wait must learn that it will not be executed
}

bool ExecutionEngine::stopTask() {
    const EngineGate::Visit visit(*gate_);
    base::ActivityInterface* const activity = visit.activity();
    if (!activity || !activity->isActive()) return true;
    // A hook that calls this is asked for any activity. An activity that asks as well gets the same answer.
    const bool within = gate_->isStepping() && in_hook_;
    if (within && !breakLoop()) return false;
    const Raised asked(within ? &break_asked_ : nullptr);
    if (!activity->stop()) return false;
    startActivity();
    return true;
}

// A sender may have queued an item while the activity was not active and refused the trigger. Both change the word of
// the wait point before they look at the other's side (mark() here, notify() in enqueue()), so either the sender finds
// the activity active or we find its item.
bool ExecutionEngine::startActivity() {
    const EngineGate::Visit visit(*gate_);
    base::ActivityInterface* const activity = visit.activity();
    if (!activity || gate_->retired() || !activity->start()) return false;
    gate_->waitPoint.mark();
    if (hasWork()) activity->trigger();
    return true;
}

// A thread that did not see the retirement has queued its item before this, see accepts(). Threads inside may be
// waiting for queued items, so these are disposed of first.
bool ExecutionEngine::retire(std::int64_t deadline) {
    auto& gate = const_cast<EngineGate&>(*gate_);
    gate.retire();
    gate_->waitPoint.notify();
    disposeQueued();
    return gate.waitUntilLeft(deadline);
}

void ExecutionEngine::setActivity(base::ActivityInterface* activity) {
    base::RunnableInterface::setActivity(activity);
    const_cast<EngineGate&>(*gate_).setActivity(activity);
}

bool ExecutionEngine::initialize() {
    internal::Presence::prepare();  // in the thread of the activity, before its first step
    return true;
}
void ExecutionEngine::step() {}
void ExecutionEngine::loop() {}
bool ExecutionEngine::breakLoop() {
    // Below Running there is no updateHook() that could refuse.
    return break_asked_ || !task_ || task_->base::TaskCore::getTaskState() < base::TaskCore::Running ||
           task_->breakUpdateHook();
}
void ExecutionEngine::finalize() {}
bool ExecutionEngine::hasWork() { return !mailbox_.empty() || ports_.any(); }

void ExecutionEngine::work(WorkReason reason) {
    const Step here(*gate_);
    // A step that begins too late: the component's subclass is being destroyed.
    if (gate_->retired() && !gate_->retiredHere()) return;
    const bool nested = !here.first();
    if (task_) {
        ++task_->mCycleCounter;
        ++(reason == Trigger ? task_->mTriggerCounter : reason == TimeOut ? task_->mTimeOutCounter : task_->mIOCounter);
    }
    // While a slave waits, its master executes the slave's triggers.
    if (ExecutionEngine::hasWork()) processMailbox(here, nested ? Depth::Waiting : Depth::Step);
    if (nested || reason == Trigger || here.gone()) return;
    functions_.process(here);
    if (!here.gone()) processHooks(here);
}

void ExecutionEngine::processMailbox(const Step& here, Depth depth) {
    if (depth == Depth::Step) callDeferredPorts(here);
    Mailbox::Item item;
    bool any = false;
    // Bounded, because executed items may queue others again and again; the rest of the step comes first.
    for (std::uint32_t left = Mailbox::kCapacity; !here.gone() && left != 0 && mailbox_.take(item); any = true) {
        if (depth == Depth::Step) --left;
        execute(here, item, depth);
    }
    if (here.gone()) return;
    // Callbacks that became due while one of these messages waited.
    if (depth == Depth::Step) callDeferredPorts(here);
    if (depth == Depth::Step && !here.gone() && ports_.takeMissed()) callPort(here, nullptr);
    if (here.gone()) return;
    // Other threads may wait here for the effect of a message.
    if (any) gate_->waitPoint.notify();
    if (depth == Depth::Step && !mailbox_.empty()) triggerSelf();
}

void ExecutionEngine::execute(const Step& here, Mailbox::Item item, Depth depth) {
    if (!item.what) return;  // withdrawn
    switch (item.kind) {
        case Mailbox::Kind::Message:
            guarded(here, task_, "a message",
                    [&] { static_cast<base::DisposableInterface*>(item.what)->executeAndDispose(); });
            break;
        case Mailbox::Kind::Port:
            // A component that calls an operation in its updateHook() does not expect its callbacks there.
            if (depth == Depth::Waiting || ports_.waiting())
                ports_.defer(static_cast<base::PortInterface*>(item.what));
            else if (!callPort(here, static_cast<base::PortInterface*>(item.what)))
                return;
            if (depth == Depth::Step) callDeferredPorts(here);
            break;
        case Mailbox::Kind::AddFunction: functions_.add(static_cast<base::ExecutableInterface*>(item.what)); break;
        case Mailbox::Kind::RemoveFunction:
            functions_.remove(*static_cast<internal::FunctionRemoval*>(item.what));
            break;
    }
}

void ExecutionEngine::callDeferredPorts(const Step& here) {
    ports_.callDeferred([&](base::PortInterface* port) { return callPort(here, port); });
}

/** False if the engine is gone. */
bool ExecutionEngine::callPort(const Step& here, base::PortInterface* port) {
    if (!task_ || !task_->port_step_) return true;
    guarded(here, task_, "the callback of a port", [&] { task_->port_step_(*task_, port); });
    return !here.gone();
}

template <class Hook>
void ExecutionEngine::callHook(const Step& here, const char* what, Hook&& hook) {
    in_hook_ = true;
    guarded(here, task_, what, std::forward<Hook>(hook));
    if (!here.gone()) in_hook_ = false;
}

void ExecutionEngine::processHooks(const Step& here) {
    if (!task_) return;
    // No virtual calls: a stopped component's subclass may be under destruction.
    using Core = base::TaskCore;
    Core::States now = task_->Core::states();
    if (now.state == Core::Running && now.target == Core::Running)
        callHook(here, "updateHook()", [this] { task_->updateHook(); });
    if (here.gone()) return;
    // error() in updateHook() takes effect in the same step.
    now = task_->Core::states();
    if (now.state == Core::RunTimeError && now.target >= Core::Running)
        callHook(here, "errorHook()", [this] { task_->errorHook(); });
}

}  // namespace RTT
