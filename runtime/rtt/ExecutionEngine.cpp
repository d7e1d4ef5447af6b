// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/ExecutionEngine.hpp>

#include <rtt/Logger.hpp>
#include <rtt/base/ActivityInterface.hpp>
#include <rtt/base/TaskCore.hpp>

#include <algorithm>
#include <exception>

namespace RTT {

using internal::Mailbox;

namespace {

/** Takes a function out of an engine, in the engine's thread. Lives on the stack of the waiting remover. */
class RemoveMessage : public base::DisposableInterface {
public:
    RemoveMessage(std::vector<base::ExecutableInterface*>& functions, base::ExecutableInterface* function,
                  std::shared_ptr<internal::WaitPoint> waitPoint)
        : functions_(functions), function_(function), wait_point_(std::move(waitPoint)) {}
    void executeAndDispose() override {
        // Leaves a hole, because the engine may be walking the list: it closes holes after the walk.
        std::replace(functions_.begin(), functions_.end(), function_, static_cast<base::ExecutableInterface*>(nullptr));
        dispose();
    }
    void dispose() override {
        const auto waitPoint = wait_point_;  // `this` is gone as soon as done_ is seen
        done_.store(true);
        waitPoint->notify();
    }
    bool done() const { return done_.load(); }

private:
    std::vector<base::ExecutableInterface*>& functions_;
    base::ExecutableInterface* function_;
    std::shared_ptr<internal::WaitPoint> wait_point_;
    std::atomic<bool> done_{false};
};

/** The steps this thread is in, innermost first: a sequential activity may execute within the step of another. */
struct Stepping {
    explicit Stepping(const ExecutionEngine* stepped) : engine(stepped), outer(innermost) { innermost = this; }
    ~Stepping() { innermost = outer; }
    const ExecutionEngine* engine;
    const Stepping* outer;
    static thread_local const Stepping* innermost;
};
thread_local const Stepping* Stepping::innermost = nullptr;

std::string nameOf(const base::TaskCore* task) { return task ? task->getName() : "GlobalEngine"; }

}  // namespace

ExecutionEngine::ExecutionEngine(base::TaskCore* owner)
    : task_(owner), wait_point_(std::make_shared<internal::WaitPoint>()) {
    functions_.reserve(16);
    deferred_ports_.reserve(16);
}

ExecutionEngine::~ExecutionEngine() {
    disposeQueued();
    for (base::ExecutableInterface* function : functions_)
        if (function) function->unloaded();
}

void ExecutionEngine::disposeQueued() {
    Mailbox::Item item;
    while (mailbox_.take(item)) {
        if (item.kind == Mailbox::Kind::Message)
            static_cast<base::DisposableInterface*>(item.what)->dispose();
        else if (item.kind == Mailbox::Kind::AddFunction)
            static_cast<base::ExecutableInterface*>(item.what)->unloaded();
    }
}

bool ExecutionEngine::accepts() const { return getActivity() && !(task_ && task_->inFatalError()); }

// The component may enter FatalError between our look at its state and put(). Its thread then enters the new state,
// notifies and disposes of what is queued, in this order; we put, notify and look at the state again. notify() changes one
// word in both, so one of the two comes second and sees what the other did before: the message is disposed of.
bool ExecutionEngine::enqueue(Mailbox::Item item) {
    if (!item.what || !accepts() || !mailbox_.put(item)) return false;
    wait_point_->notify();  // this engine's thread may be inside waitForMessages()
    if (!accepts()) {
        disposeQueued();
        return true;
    }
    getActivity()->trigger();
    return true;
}

bool ExecutionEngine::process(base::DisposableInterface* message) { return enqueue({Mailbox::Kind::Message, message}); }

bool ExecutionEngine::process(base::PortInterface* port) { return enqueue({Mailbox::Kind::Port, port}); }

bool ExecutionEngine::runFunction(base::ExecutableInterface* function) {
    if (!function || !accepts()) return false;
    function->loaded(this);
    if (enqueue({Mailbox::Kind::AddFunction, function})) return true;
    function->unloaded();
    return false;
}

bool ExecutionEngine::removeFunction(base::ExecutableInterface* function) {
    if (!function || !function->isLoaded() || function->getEngine() != this) return true;
    RemoveMessage message(functions_, function, wait_point_);
    base::ActivityInterface* activity = getActivity();
    if (activity && activity->isActive() && !isSelf()) {
        // The queue is in order, so an addition that still waits in it is executed before the removal.
        if (!process(&message)) return false;
        waitForMessages([&] { return message.done(); });
    } else {
        processMailbox(Depth::Waiting);
        message.executeAndDispose();
    }
    function->unloaded();
    return true;
}

void ExecutionEngine::waitForMessages(const boost::function<bool()>& done) {
    const bool self = isSelf();
    while (!done()) {
        const std::uint32_t ticket = wait_point_->prepare();
        if (self) processMailbox(Depth::Waiting);
        if (done() || (self && !mailbox_.empty()))
            wait_point_->cancel();
        else
            wait_point_->wait(ticket);
    }
    // The trigger that came with the port may have been used up before we waited.
    if (self && deferred_ && getActivity()) getActivity()->trigger();
}

bool ExecutionEngine::isSelf() const { return getActivity() && getActivity()->isSelf(); }

bool ExecutionEngine::isStepping() const {
    for (const Stepping* step = Stepping::innermost; step; step = step->outer)
        if (step->engine == this) return true;
    return false;
}

void ExecutionEngine::setExceptionTask() {
    log(Error) << "in " << nameOf(task_) << ": a sent operation threw an exception" << endlog();
    if (task_) task_->exception();
}

void ExecutionEngine::setFatalTask() {
    wait_point_->notify();  // see enqueue()
    base::ActivityInterface* activity = getActivity();
    // If it does not stop, its thread executes what is queued; else nobody will, and those who wait must learn that.
    if (!activity || !activity->isActive() || activity->stop()) disposeQueued();
}

bool ExecutionEngine::stopTask() {
    base::ActivityInterface* activity = getActivity();
    if (!activity || !activity->isActive()) return true;
    if (!activity->stop()) return false;
    activity->start();
    return true;
}

bool ExecutionEngine::initialize() { return true; }
void ExecutionEngine::step() {}
void ExecutionEngine::loop() {}
bool ExecutionEngine::breakLoop() { return task_ ? task_->breakUpdateHook() : true; }
void ExecutionEngine::finalize() {}
bool ExecutionEngine::hasWork() { return !mailbox_.empty() || deferred_; }

void ExecutionEngine::work(WorkReason reason) {
    const Stepping here(this);
    if (task_) {
        ++task_->mCycleCounter;
        ++(reason == Trigger ? task_->mTriggerCounter : reason == TimeOut ? task_->mTimeOutCounter : task_->mIOCounter);
    }
    processMailbox(Depth::Step);
    if (reason == Trigger) return;
    processFunctions();
    processHooks();
}

// Calls what others wrote. False if it threw; the component is in Exception then.
template <class Action>
bool ExecutionEngine::guarded(const char* what, Action&& action) {
    try {
        action();
        return true;
    } catch (const std::exception& e) {
        log(Error) << "in " << nameOf(task_) << ": " << what << " threw: " << e.what() << endlog();
    } catch (...) {
        log(Error) << "in " << nameOf(task_) << ": " << what << " threw something that is no std::exception"
                   << endlog();
    }
    if (task_) task_->exception();
    return false;
}

void ExecutionEngine::processMailbox(Depth depth) {
    if (depth == Depth::Step) callDeferredPorts();
    Mailbox::Item item;
    while (mailbox_.take(item)) execute(item, depth);
    // Those that came up while one of these messages waited for something.
    if (depth == Depth::Step) callDeferredPorts();
}

void ExecutionEngine::execute(Mailbox::Item item, Depth depth) {
    switch (item.kind) {
        case Mailbox::Kind::Message:
            guarded("a message", [&] { static_cast<base::DisposableInterface*>(item.what)->executeAndDispose(); });
            break;
        case Mailbox::Kind::Port:
            // A component in the middle of its updateHook() does not expect its callbacks because it calls somebody.
            deferred_ports_.push_back(static_cast<base::PortInterface*>(item.what));
            deferred_ = true;
            if (depth == Depth::Step) callDeferredPorts();
            break;
        case Mailbox::Kind::AddFunction:
            functions_.push_back(static_cast<base::ExecutableInterface*>(item.what));
            break;
    }
}

void ExecutionEngine::callDeferredPorts() {
    if (!deferred_) return;
    // By index: a callback that waits for something may add to the list.
    for (std::size_t i = 0; i != deferred_ports_.size(); ++i)
        if (task_) guarded("the callback of a port", [&] { task_->dataOnPortCallback(deferred_ports_[i]); });
    deferred_ports_.clear();
    deferred_ = false;
}

void ExecutionEngine::processFunctions() {
    // Functions added or removed by those that run here take effect in the next step.
    for (std::size_t i = 0, count = functions_.size(); i != count; ++i) {
        base::ExecutableInterface* function = functions_[i];
        bool again = false;
        if (!function || (guarded("a function", [&] { again = function->execute(); }) && again)) continue;
        if (functions_[i] == function) {
            functions_[i] = nullptr;
            function->unloaded();
        }
    }
    functions_.erase(std::remove(functions_.begin(), functions_.end(), nullptr), functions_.end());
}

void ExecutionEngine::processHooks() {
    if (!task_) return;
    using Core = base::TaskCore;
    if (task_->getTaskState() == Core::Running && task_->getTargetState() == Core::Running)
        guarded("updateHook()", [this] { task_->updateHook(); });
    // error() in updateHook() is served in the same step.
    if (task_->getTaskState() == Core::RunTimeError && task_->getTargetState() >= Core::Running)
        guarded("errorHook()", [this] { task_->errorHook(); });
}

}  // namespace RTT
