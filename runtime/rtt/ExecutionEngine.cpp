// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The parts of a step. engine_queue.cpp has the requests of other threads.
#include <rtt/ExecutionEngine.hpp>

#include <rtt/Logger.hpp>
#include <rtt/base/ActivityInterface.hpp>
#include <rtt/base/TaskCore.hpp>
#include <rtt/internal/engine/hook_in_progress.hpp>
#include <rtt/internal/engine/detail/engine_removal.hpp>

#include <exception>
#include <utility>

namespace RTT {

using internal::EngineGate;
using internal::Mailbox;

namespace {
std::string nameOf(const base::TaskCore* task) { return task ? task->base::TaskCore::getName() : "GlobalEngine"; }

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

ExecutionEngine::ExecutionEngine(base::TaskCore* owner) : gate_(new EngineGate(this)), task_(owner) {
    deferred_ports_.reserve(16);  // its final capacity
}

ExecutionEngine::~ExecutionEngine() {
    const_cast<EngineGate&>(*gate_).close();  // from here on no thread puts anything into the queue
    disposeQueued();
    functions_.forEach([](base::ExecutableInterface& function) { function.unloaded(); });
}

void ExecutionEngine::setExceptionTask() {
    log(Error) << "in " << nameOf(task_) << ": a sent operation threw an exception" << endlog();
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
bool ExecutionEngine::hasWork() { return !mailbox_.empty() || deferred_ || missed_ports_; }

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
    processFunctions(here);
    if (!here.gone()) processHooks(here);
}

// Calls user code. False if that threw; the component is then in Exception.
template <class Action>
bool ExecutionEngine::guarded(const Step& here, const char* what, Action&& action) {
    try {
        const internal::HookInProgress hook(task_, what);
        action();
        return true;
    } catch (const std::exception& e) {
        logException(here, what, e.what());
    } catch (...) {
        logException(here, what, "something that is no std::exception");
    }
    if (!here.gone() && task_) task_->exception();
    return false;
}

// Separate, so that a normal step does not prepare for it.
[[gnu::cold, gnu::noinline]] void ExecutionEngine::logException(const Step& here, const char* what, const char* why) {
    log(Error) << "in " << (here.gone() ? "a component that is no more" : nameOf(task_)) << ": " << what
               << " threw: " << why << endlog();
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
    if (depth == Depth::Step && !here.gone()) callMissedPorts(here);
    if (here.gone()) return;
    // Other threads may wait here for the effect of a message.
    if (any) gate_->waitPoint.notify();
    if (depth == Depth::Step && !mailbox_.empty()) triggerSelf();
}

void ExecutionEngine::execute(const Step& here, Mailbox::Item item, Depth depth) {
    if (!item.what) return;  // withdrawn
    switch (item.kind) {
        case Mailbox::Kind::Message:
            guarded(here, "a message",
                    [&] { static_cast<base::DisposableInterface*>(item.what)->executeAndDispose(); });
            break;
        case Mailbox::Kind::Port:
            // A component that calls an operation in its updateHook() does not expect its callbacks there.
            if (depth == Depth::Waiting || !deferred_ports_.empty()) {
                if (deferred_ports_.size() == deferred_ports_.capacity()) {
                    missed_ports_.exchange(true);
                } else {
                    deferred_ports_.push_back(static_cast<base::PortInterface*>(item.what));
                    deferred_ = true;
                }
            } else {
                callPort(here, static_cast<base::PortInterface*>(item.what));
                if (here.gone()) return;
            }
            if (depth == Depth::Step) callDeferredPorts(here);
            break;
        case Mailbox::Kind::AddFunction: functions_.add(static_cast<base::ExecutableInterface*>(item.what)); break;
        case Mailbox::Kind::RemoveFunction: {
            auto* const removal = static_cast<Removal*>(item.what);
            functions_.remove(removal->function);
            if (executing_ == removal->function) {
                // Its execute() is waiting, further down the stack.
                removal->next = removals_;
                removals_ = removal;
            } else {
                removal->finish(Removal::Removed);
            }
            break;
        }
    }
}

void ExecutionEngine::callDeferredPorts(const Step& here) {
    if (!deferred_) return;
    // By index: a callback that waits may add to the list.
    for (std::size_t i = 0; i != deferred_ports_.size(); ++i) {
        callPort(here, deferred_ports_[i]);
        if (here.gone()) return;
    }
    deferred_ports_.clear();
    deferred_ = false;
}

// A thread that sets the flag has announced its port before, and triggers afterwards.
void ExecutionEngine::callMissedPorts(const Step& here) {
    if (missed_ports_ && missed_ports_.exchange(false)) callPort(here, nullptr);
}

void ExecutionEngine::callPort(const Step& here, base::PortInterface* port) {
    if (!task_ || !task_->port_step_) return;
    guarded(here, "the callback of a port", [&] { task_->port_step_(*task_, port); });
}

void ExecutionEngine::processFunctions(const Step& here) {
    // Functions that are added or removed meanwhile take effect in the next step; those that are woken, in this one if
    // their turn is still to come.
    internal::FunctionList::Round round = functions_.begin();
    if (round.end == 0) return;
    functions_.takeWoken();
    while (base::ExecutableInterface* const function = functions_.next(round)) {
        if (task_ && task_->base::TaskCore::inFatalError()) return;
        if (task_ && task_->base::TaskCore::inException() && function->pausesInException()) continue;
        executing_ = function;
        bool again = false;
        const bool returned = guarded(here, "a function", [&] { again = function->execute(); });
        if (here.gone()) return;
        executing_ = nullptr;
        if (functions_.has(round, function)) {
            if (returned && again)
                functions_.rest(round);
            else
                unload(round, *function);
        }
        while (Removal* const removal = removals_) {
            removals_ = removal->next;
            removal->finish(Removal::Removed);
        }
        functions_.takeWoken();
    }
    functions_.tidy();
}

// While the component waits. True if some have to be executed again, which no notification will announce.
bool ExecutionEngine::processAwaited(const Step& here) {
    bool left = false;
    internal::FunctionList::Round round = functions_.begin();
    while (base::ExecutableInterface* const function = functions_.next(round)) {
        if (task_ && task_->base::TaskCore::inFatalError()) return false;
        if (function == executing_ || !function->isAwaited()) continue;
        bool again = false;
        guarded(here, "a function", [&] { again = function->execute(); });
        if (here.gone()) return false;
        left = left || again;
        if (!again && functions_.has(round, function)) unload(round, *function);
    }
    return left;
}

void ExecutionEngine::unload(const internal::FunctionList::Round& round, base::ExecutableInterface& function) {
    functions_.drop(round);
    function.unloaded();
}

template <class Hook>
void ExecutionEngine::callHook(const Step& here, const char* what, Hook&& hook) {
    in_hook_ = true;
    guarded(here, what, std::forward<Hook>(hook));
    if (!here.gone()) in_hook_ = false;
}

void ExecutionEngine::processHooks(const Step& here) {
    if (!task_) return;
    // No virtual calls: a stopped component's subclass may be under destruction.
    using Core = base::TaskCore;
    if (task_->Core::getTaskState() == Core::Running && task_->Core::getTargetState() == Core::Running)
        callHook(here, "updateHook()", [this] { task_->updateHook(); });
    if (here.gone()) return;
    // error() in updateHook() takes effect in the same step.
    if (task_->Core::getTaskState() == Core::RunTimeError && task_->Core::getTargetState() >= Core::Running)
        callHook(here, "errorHook()", [this] { task_->errorHook(); });
}

}  // namespace RTT
