// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/TaskContext.hpp>

#include <rtt/Activity.hpp>
#include <rtt/Logger.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/internal/calls/failed.hpp>
#include <rtt/internal/engine/deferred_activity.hpp>
#include <rtt/internal/engine/other_order.hpp>
#include <rtt/internal/engine/topology.hpp>
#include <rtt/internal/plugin_loading.hpp>
#include <rtt/os/ThreadInterface.hpp>
#include <rtt/os/fosi.h>

#include <exception>
#include <new>

namespace RTT {

namespace {

base::ActivityInterface* makeDefaultActivity(const std::string& name) {
#ifdef ORO_ACT_DEFAULT_SEQUENTIAL
    static_cast<void>(name);
    return new extras::SequentialActivity;
#else
    if (internal::ActivityFollows::take(name)) return new internal::DeferredActivity(name);
    // Without the engine, because others may be triggering that while the activity is being constructed.
    return new Activity(nullptr, name);
#endif
}

/** What the component gets instead: a default activity for null, or what a replay executes. */
base::ActivityInterface::shared_ptr inOrder(base::ActivityInterface::shared_ptr given, const std::string& name) {
    if (internal::OtherOrder* const order = internal::OtherOrder::installed())
        return order->replace(std::move(given), name);
    if (!given) given.reset(makeDefaultActivity(name));
    return given;
}

bool isMadeBy(const base::ActivityInterface* owned, const base::ActivityInterface* activity) {
    const auto* const deferred = dynamic_cast<const internal::DeferredActivity*>(owned);
    return deferred && deferred->ifMade() == activity;
}

}  // namespace

TaskContext::TaskContext(const std::string& name, TaskState initial_state)
    : TaskCore(initial_state, name),
      service_(boost::make_shared<Service>(name)),
      requester_(boost::make_shared<ServiceRequester>(name, this)) {
    port_step_ = &TaskContext::portStep;
    service_->setOwner(this);
    service_->doc("The interface of this TaskContext.");
    addAttribute("TriggerOnStart", mTriggerOnStart);
    addAttribute("CycleCounter", mCycleCounter);
    addAttribute("IOCounter", mIOCounter);
    addAttribute("TimeOutCounter", mTimeOutCounter);
    addAttribute("TriggerCounter", mTriggerCounter);
    service_->addStandardLater();
    setActivity(nullptr);
}

TaskContext::~TaskContext() {
    // A component without a thread of its own is not being executed now.
    if (isRunning() && isActive() && activity_->thread() && !activity_->thread()->isSelf())
        log(Warning) << getName()
                     << " is destroyed while it is running: its thread may meet what is left of it. Call stopForGood() "
                     << "in the destructor of its class" << endlog();
    endExecution();
    // Others may hold these pointers longer than the component exists.
    service_->setOwner(nullptr);
    requester_->setOwner(nullptr);
    releaseProviders();
    clear();
    leaveAll();
    releaseActivity();
}

// Code that still holds one can connect it to another service. It owns its callers, unlike those of requires_().
void TaskContext::releaseProviders() {
    for (const auto& entry : providers_) {
        if (!entry.second) continue;
        entry.second->setOwner(nullptr);
        for (const std::string& name : entry.second->getOperationCallerNames())
            entry.second->getOperationCaller(name)->setCaller(nullptr);
    }
    providers_.clear();
}

const std::string& TaskContext::getName() const { return service_->getName(); }

bool TaskContext::setActivity(base::ActivityInterface* new_act) {
    if (new_act && (new_act == activity_.get() || isMadeBy(activity_.get(), new_act)))
        return true;  // it is owned already
    base::ActivityInterface::shared_ptr owned(new_act);
    const char* why = nullptr;
    if (isRunning())
        why = "while the component is running";
    else if (engine()->isStepping())
        why = "by the thread of the present one";
    else if (activity_ && activity_->isActive() && !activity_->stop() && activity_->isActive())
        why = "because the present one does not stop";
    if (why) {
        log(Error) << getName() << ": the activity cannot be changed " << why << endlog();
        owned.reset();
        // If the new one was made with the engine, it is attached to that.
        if (engine()->getActivity() != activity_.get()) engine()->setActivity(activity_.get());
        return false;
    }
    exchangeActivity(inOrder(std::move(owned), getName()));
    return true;
}

void TaskContext::forceActivity(base::ActivityInterface* new_act) {
    if (!new_act || new_act == activity_.get() || isMadeBy(activity_.get(), new_act)) return;
    if (activity_) activity_->stop();
    exchangeActivity(inOrder(base::ActivityInterface::shared_ptr(new_act), getName()));
}

void TaskContext::exchangeActivity(base::ActivityInterface::shared_ptr next) {
    next->stop();
    next->run(engine());  // before the old one is detached, because senders must find an activity meanwhile
    activity_.swap(next);
    if (next) next->run(nullptr);
    next.reset();  // its thread ends before the new one starts
    engine()->startActivity();
    internal::Topology::changed();
}

namespace {

/** Destroys an activity in the thread of the GlobalEngine, when it has returned from the step that requested it. */
class ActivityRelease : public base::DisposableInterface {
public:
    ActivityRelease(base::ActivityInterface::shared_ptr activity, boost::intrusive_ptr<const internal::EngineGate> gate)
        : activity_(std::move(activity)), gate_(std::move(gate)) {}
    void executeAndDispose() override {
        gate_->waitForVisitors();  // threads that execute a sequential activity or a slave
        delete this;               // joins the thread
    }
    void dispose() override { delete this; }

private:
    base::ActivityInterface::shared_ptr activity_;
    boost::intrusive_ptr<const internal::EngineGate> gate_;
};

}  // namespace

void TaskContext::releaseActivity() {
    if (!activity_) return;
    const bool withinStep = engine()->isStepping();
    // The activity's destructor would also wait for an executing thread, but without executing this thread's messages,
    // for one of which that thread may be waiting.
    engine()->setActivity(nullptr);
    if (!withinStep && activity_->isActive()) {
        engine()->gate()->waitForStep();
        activity_->stop();
    }
    activity_->run(nullptr);
    if (withinStep) {
        // Its code is further down the stack of this thread. Moved, so that it is not destroyed below.
        auto* const release = new ActivityRelease(std::move(activity_), engine()->gate());
        if (!internal::GlobalEngine::Instance()->process(release))
            log(Error) << getName() << ": the activity of the destroyed component cannot be released" << endlog();
    }
    activity_.reset();
}

// The caller may want an Activity, so one is made; but not by a destructor that stops it.
base::ActivityInterface* TaskContext::getActivity() {
    auto* const deferred = dynamic_cast<internal::DeferredActivity*>(activity_.get());
    if (!deferred) return activity_.get();
    if (!engine()->gate()->retired()) return deferred->made();
    base::ActivityInterface* const made = deferred->ifMade();
    return made ? made : deferred;
}

bool TaskContext::endExecution(Seconds limit) {
    const std::int64_t deadline = limit < 0 ? INT64_MAX : rtos_get_time_ns() + Seconds_to_nsecs(limit);
    // No step begins after that; the current one is asked to end.
    if (activity_ && !engine()->gate()->retired()) activity_->stop();
    const bool left = engine()->retire(deadline);
    // Another thread may have started it at that moment.
    if (activity_ && activity_->isActive()) activity_->stop();
    return left;
}

bool TaskContext::stopForGood(Seconds limit) noexcept {
    try {
        // Its own state: what stands for a component of another process leaves that running.
        if (TaskCore::isRunning() && !engine()->gate()->retired()) stop();
    } catch (const std::exception& thrown) {
        log(Error) << getName() << " is stopped for good, though stop() threw: " << thrown.what() << endlog();
    } catch (...) {
        log(Error) << getName() << " is stopped for good, though stop() threw something that is no std::exception"
                   << endlog();
    }
    if (endExecution(limit)) return true;
    log(Error) << getName() << " is stopped for good, but another thread is still executing a part of it" << endlog();
    return false;
}

bool TaskContext::start() {
    if (isRunning()) return false;
    if (engine()->gate()->retired()) {
        log(Error) << getName() << " cannot be started: it was stopped for good" << endlog();
        return false;
    }
    try {
        if (mTriggerOnStart && getTaskState() == Stopped) (void)getActivity();  // the component needs its thread now
    } catch (const std::bad_alloc& thrown) {
        log(Error) << getName() << " cannot be started: " << thrown.what() << endlog();
        return false;
    }
    return TaskCore::start();
}
bool TaskContext::stop() { return TaskCore::stop(); }
bool TaskContext::ready() { return true; }

void TaskContext::clear() {
    service_->clear();
    requester_->clear();
}

bool TaskContext::connectPorts(TaskContext* peer) {
    if (!peer) return false;
    bool success = true;
    for (base::PortInterface* mine : ports()->getPorts()) {
        base::PortInterface* theirs = peer->ports()->getPort(mine->getName());
        if (!theirs) {
            log(Debug) << peer->getName() << " has no port '" << mine->getName() << "' to connect that of " << getName()
                       << " with" << endlog();
            continue;
        }
        const bool mineReads = mine->asInput() != nullptr;
        const bool theirsReads = theirs->asInput() != nullptr;
        if (mineReads == theirsReads) {
            log(Debug) << "ports '" << mine->getName() << "' of " << getName() << " and " << peer->getName()
                       << " have the same direction and are not connected" << endlog();
            continue;
        }
        if (!mine->connectTo(theirs)) success = false;
    }
    return success;
}

bool TaskContext::connectServices(TaskContext* peer) {
    if (!peer) return false;
    bool success = true;
    TaskContext* const pairs[][2] = {{this, peer}, {peer, this}};
    for (const auto& pair : pairs) {
        const ServiceRequester::shared_ptr root = pair[0]->requires_();
        root->connectTo(pair[1]->provides());
        for (const std::string& name : root->getRequesterNames()) {
            const ServiceRequester::shared_ptr requester = root->requires_(name);
            if (requester->ready()) continue;
            if (!pair[1]->provides()->hasService(name)) {
                log(Debug) << pair[1]->getName() << " has no service '" << name << "' for " << pair[0]->getName()
                           << endlog();
            } else if (!requester->connectTo(pair[1]->provides(name))) {
                log(Error) << "service '" << name << "' of " << pair[1]->getName() << " does not offer all that "
                           << pair[0]->getName() << " requires of it: " << requester->missingOperations() << endlog();
                success = false;
            }
        }
    }
    return success;
}

bool TaskContext::loadService(const std::string& name) {
    return service_->hasService(name) ||
           internal::toldOr("could not load service '" + name + "' into component '" + getName() + "'",
                            [&] { return internal::loadServicePlugin(name, this); });
}

bool TaskContext::dataOnPortHook(base::PortInterface*) { return isRunning(); }

void TaskContext::dataOnPort(base::PortInterface* port) {
    // The hook belongs to a class that may be under destruction.
    const internal::EngineGate::Visit visit(*engine()->gate());
    if (!visit.engine()) return;
    // The component may be started, and stopped, while the hook decides.
    const unsigned starts = mStartCounter;
    const bool running = isRunning();
    if (!dataOnPortHook(port)) return;
    const std::uint64_t announcement = port_callbacks_.announce(port, running || mStartCounter != starts);
    if (!announcement) return;
    (void)engine()->process(port, visit, [this, port, announcement] { port_callbacks_.queued(port, announcement); });
}

void TaskContext::dataOnPortCallback(base::PortInterface* port) { port_callbacks_.call(port, true); }

void TaskContext::portStep(base::TaskCore& task, base::PortInterface* port) {
    auto& self = static_cast<TaskContext&>(task);
    if (port) return self.callbackOf(port);
    std::uint64_t last = 0;
    while (base::PortInterface* const next = self.port_callbacks_.nextAnnounced(last)) self.callbackOf(next);
}

// stop() changes the target first and then waits for the step in progress, so every later step sees the change. After
// it the subclass may be under destruction, so its functions must not be called, unless its own hook wants callbacks
// while it is stopped. A port that was removed after it had been queued may be destroyed.
void TaskContext::callbackOf(base::PortInterface* port) {
    typedef internal::PortCallbacks::Announced Announced;
    const internal::PortCallbacks::Execution execution(port_callbacks_, port);
    const Announced announced = execution.announced();
    if (announced == Announced::Not) return;
    const bool running = TaskCore::getTaskState() >= Running && TaskCore::getTargetState() >= Running;
    if (running || announced == Announced::WhileStopped)
        dataOnPortCallback(port);
    else
        port_callbacks_.call(port, false);
}

void TaskContext::setDataOnPortCallback(base::InputPortInterface* port, const SlotFunction& callback) {
    port_callbacks_.set(port, callback ? callback : SlotFunction([this](base::PortInterface*) { trigger(); }));
}

void TaskContext::dataOnPortRemoved(base::PortInterface* port) {
    // Within its own step the component may be under destruction.
    port_callbacks_.remove(port, !engine()->isStepping());
}

}  // namespace RTT
