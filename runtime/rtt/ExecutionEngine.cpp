// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a step consists of. How it is asked for is in engine_queue.cpp.
#include <rtt/ExecutionEngine.hpp>

#include <rtt/Logger.hpp>
#include <rtt/base/ActivityInterface.hpp>
#include <rtt/base/TaskCore.hpp>
#include <rtt/internal/HookInProgress.hpp>
#include <rtt/internal/detail/engine_removal.hpp>

#include <algorithm>
#include <exception>

namespace RTT {

using internal::EngineGate;
using internal::Mailbox;

namespace {
std::string nameOf(const base::TaskCore* task) { return task ? task->base::TaskCore::getName() : "GlobalEngine"; }
}  // namespace

ExecutionEngine::ExecutionEngine(base::TaskCore* owner) : gate_(new EngineGate(this)), task_(owner) {
    functions_.reserve(64);
    deferred_ports_.reserve(16);  // and never more
}

ExecutionEngine::~ExecutionEngine() {
    const_cast<EngineGate&>(*gate_).close();  // from here on nobody puts anything into the queue
    disposeQueued();
    for (base::ExecutableInterface* function : functions_)
        if (function) function->unloaded();
}

void ExecutionEngine::setExceptionTask() {
    log(Error) << "in " << nameOf(task_) << ": a sent operation threw an exception" << endlog();
    enterException();
}

void ExecutionEngine::enterException() {
    if (task_) task_->exception();
}

void ExecutionEngine::setFatalTask() {
    // See accepts(): who has queued something and did not see the new state has done so before this.
    gate_->waitPoint.notify();
    const EngineGate::Visit visit(*gate_);
    if (base::ActivityInterface* activity = visit.activity()) activity->stop();
    disposeQueued();  // those who wait must learn that nobody will execute it
}

bool ExecutionEngine::stopTask() {
    const EngineGate::Visit visit(*gate_);
    base::ActivityInterface* const activity = visit.activity();
    if (!activity || !activity->isActive()) return true;
    if (!activity->stop()) return false;
    startActivity();
    return true;
}

// A sender may have queued something while the activity was not active, so that its trigger was refused. Both change the
// word of the wait point before they look at what the other one does (mark() here, notify() in enqueue()), so either
// the sender finds the activity active or we find what it queued.
bool ExecutionEngine::startActivity() {
    const EngineGate::Visit visit(*gate_);
    base::ActivityInterface* const activity = visit.activity();
    if (!activity || !activity->start()) return false;
    gate_->waitPoint.mark();
    if (hasWork()) activity->trigger();
    return true;
}

void ExecutionEngine::setActivity(base::ActivityInterface* activity) {
    base::RunnableInterface::setActivity(activity);
    const_cast<EngineGate&>(*gate_).setActivity(activity);
}

bool ExecutionEngine::initialize() { return true; }
void ExecutionEngine::step() {}
void ExecutionEngine::loop() {}
bool ExecutionEngine::breakLoop() { return task_ ? task_->breakUpdateHook() : true; }
void ExecutionEngine::finalize() {}
bool ExecutionEngine::hasWork() { return !mailbox_.empty() || deferred_ || missed_ports_; }

void ExecutionEngine::work(WorkReason reason) {
    const bool nested = gate_->isStepping();
    const Step here(*gate_);
    if (task_) {
        ++task_->mCycleCounter;
        ++(reason == Trigger ? task_->mTriggerCounter : reason == TimeOut ? task_->mTimeOutCounter : task_->mIOCounter);
    }
    // The master of a slave that waits executes the slave's triggers meanwhile.
    processMailbox(here, nested ? Depth::Waiting : Depth::Step);
    if (nested || reason == Trigger || here.gone()) return;
    processFunctions(here);
    if (!here.gone()) processHooks(here);
}

// Calls what others wrote. False if it threw; the component is in Exception then.
template <class Action>
bool ExecutionEngine::guarded(const Step& here, const char* what, Action&& action) {
    std::string why;
    try {
        const internal::HookInProgress hook(task_, what);
        action();
        return true;
    } catch (const std::exception& e) {
        why = e.what();
    } catch (...) {
        why = "something that is no std::exception";
    }
    log(Error) << "in " << (here.gone() ? "a component that is no more" : nameOf(task_)) << ": " << what
               << " threw: " << why << endlog();
    if (!here.gone() && task_) task_->exception();
    return false;
}

void ExecutionEngine::processMailbox(const Step& here, Depth depth) {
    if (depth == Depth::Step) callDeferredPorts(here);
    Mailbox::Item item;
    bool any = false;
    // What a step executes may ask for more of it, again and again: the rest of the step comes first.
    for (std::uint32_t left = Mailbox::kCapacity; !here.gone() && left != 0 && mailbox_.take(item); any = true) {
        if (depth == Depth::Step) --left;
        execute(here, item, depth);
    }
    if (here.gone()) return;
    // Those that came up while one of these messages waited for something.
    if (depth == Depth::Step) callDeferredPorts(here);
    if (depth == Depth::Step && !here.gone()) callMissedPorts(here);
    if (here.gone()) return;
    // Other threads may wait here for what a message does.
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
            // A component in the middle of its updateHook() does not expect its callbacks because it calls somebody.
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
        case Mailbox::Kind::AddFunction:
            functions_.push_back(static_cast<base::ExecutableInterface*>(item.what));
            break;
        case Mailbox::Kind::RemoveFunction: {
            auto* const removal = static_cast<Removal*>(item.what);
            // Leaves a hole, because the engine may be walking the list: it closes holes after the walk.
            takeOut(removal->function);
            if (executing_ == removal->function) {
                // Its execute() waits for something, further down the stack.
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
    // By index: a callback that waits for something may add to the list.
    for (std::size_t i = 0; i != deferred_ports_.size(); ++i) {
        callPort(here, deferred_ports_[i]);
        if (here.gone()) return;
    }
    deferred_ports_.clear();
    deferred_ = false;
}

// Whoever sets the flag has announced its port before, and triggers afterwards.
void ExecutionEngine::callMissedPorts(const Step& here) {
    if (missed_ports_ && missed_ports_.exchange(false)) callPort(here, nullptr);
}

void ExecutionEngine::callPort(const Step& here, base::PortInterface* port) {
    if (!task_ || !task_->port_step_) return;
    guarded(here, "the callback of a port", [&] { task_->port_step_(*task_, port); });
}

void ExecutionEngine::processFunctions(const Step& here) {
    // Functions added or removed by those that run here take effect in the next step.
    for (std::size_t i = 0, count = functions_.size(); i != count; ++i) {
        base::ExecutableInterface* function = functions_[i];
        if (task_ && task_->base::TaskCore::inFatalError()) return;
        if (!function) continue;
        executing_ = function;
        bool again = false;
        const bool returned = guarded(here, "a function", [&] { again = function->execute(); });
        if (here.gone()) return;
        executing_ = nullptr;
        if (!(returned && again) && functions_[i] == function) {
            functions_[i] = nullptr;
            function->unloaded();
        }
        while (Removal* const removal = removals_) {
            removals_ = removal->next;
            removal->finish(Removal::Removed);
        }
    }
    functions_.erase(std::remove(functions_.begin(), functions_.end(), nullptr), functions_.end());
}

// While the component waits. True if there are some left: nobody will tell that it is their turn.
bool ExecutionEngine::processAwaited(const Step& here) {
    bool left = false;
    for (std::size_t i = 0, count = functions_.size(); i != count; ++i) {
        if (task_ && task_->base::TaskCore::inFatalError()) return false;
        base::ExecutableInterface* const function = functions_[i];
        if (!function || function == executing_ || !function->isAwaited()) continue;
        bool again = false;
        guarded(here, "a function", [&] { again = function->execute(); });
        if (here.gone()) return false;
        left = left || again;
        if (again || functions_[i] != function) continue;
        functions_[i] = nullptr;
        function->unloaded();
    }
    return left;
}

void ExecutionEngine::processHooks(const Step& here) {
    if (!task_) return;
    // Not through the virtual functions: a sub-class of a component that was stopped may be under destruction.
    using Core = base::TaskCore;
    if (task_->Core::getTaskState() == Core::Running && task_->Core::getTargetState() == Core::Running)
        guarded(here, "updateHook()", [this] { task_->updateHook(); });
    if (here.gone()) return;
    // error() in updateHook() is served in the same step.
    if (task_->Core::getTaskState() == Core::RunTimeError && task_->Core::getTargetState() >= Core::Running)
        guarded(here, "errorHook()", [this] { task_->errorHook(); });
}

}  // namespace RTT
