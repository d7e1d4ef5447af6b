// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/extras/SlaveActivity.hpp>

#include <rtt/base/DisposableInterface.hpp>
#include <rtt/internal/engine/access_gate.hpp>
#include <rtt/internal/engine/presence.hpp>
#include <rtt/internal/engine/try_flag.hpp>
#include <rtt/os/MainThread.hpp>
#include <rtt/os/MutexLock.hpp>
#include <rtt/os/futex.hpp>
#include <rtt/os/os_log.hpp>
#include <rtt/os/priority_lock.hpp>

#include <exception>

namespace RTT::extras {

/**
 * The only message of a slave, made once so that trigger() does not allocate. It is in the queue of the master at most
 * once. Slave and queue both own it, because it may still be there when the slave is destroyed.
 */
class SlaveActivity::TriggerMessage : public base::DisposableInterface {
public:
    explicit TriggerMessage(SlaveActivity* slave) : slave_(slave) {}

    /** True if the caller must queue it: it is not queued yet. Release and acquire as in WakeWord::post(). */
    bool claim() {
        if (queued_.exchange(true, std::memory_order_acq_rel)) return false;
        owners_.fetch_add(1, std::memory_order_relaxed);
        return true;
    }
    void disconnect() {
        {
            os::MutexLock lock(mutex_);  // waits for an execution in the thread of the master
            slave_ = nullptr;
        }
        release();
    }

    void executeAndDispose() override {
        // Before the work: a trigger that comes while it executes must lead to another one.
        queued_.exchange(false, std::memory_order_acq_rel);
        const Owner atEnd{*this};  // even if the component throws
        os::MutexLock lock(mutex_);
        if (slave_) slave_->executeTrigger();
    }
    void dispose() override {
        queued_.exchange(false, std::memory_order_acq_rel);
        release();
    }
    bool isError() const override { return false; }

private:
    struct Owner {
        TriggerMessage& message;
        ~Owner() { message.release(); }
    };
    void release() {
        if (owners_.fetch_sub(1, std::memory_order_acq_rel) == 1) delete this;
    }

    os::MutexRecursive
        mutex_;  // recursive, because the slave may wait in its work while the master executes the next trigger
    SlaveActivity* slave_;
    std::atomic<bool> queued_{false};
    std::atomic<int> owners_{1};
};

/** Ends an execution, even if the component throws. */
struct SlaveActivity::Leave {
    SlaveActivity& slave;
    internal::Presence::Place& place;
    ~Leave() {
        slave.executor_.store(0, std::memory_order_release);
        internal::Presence::leave(place);  // another thread may destroy the slave from here on
    }
};

namespace {
/** A thread uses an object while this exists. */
struct Use {
    explicit Use(const void* what) : place(internal::Presence::enter(what)) {}
    ~Use() { internal::Presence::leave(place); }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;
    internal::Presence::Place& place;
};
}  // namespace

SlaveActivity::SlaveActivity(base::ActivityInterface* master, base::RunnableInterface* r)
    : master_(master),
      masterGate_(master ? master->gate() : nullptr),
      period_(master ? master->getPeriod() : 0.0),
      periodic_(period_ != 0.0),
      message_(new TriggerMessage(this)) {
    adopt(r);
}

SlaveActivity::SlaveActivity(double period, base::RunnableInterface* r)
    : master_(nullptr), period_(period), periodic_(period != 0.0), message_(new TriggerMessage(this)) {
    adopt(r);
}

SlaveActivity::SlaveActivity(base::RunnableInterface* r) : SlaveActivity(0.0, r) {}

SlaveActivity::~SlaveActivity() {
    closeGate();
    stop();
    // Waits for an execution that has not ended in time.
    waitForExecution(os::detail::kForever);
    (void)internal::Presence::Waiter(&message_).wait(os::detail::kForever);
    internal::Presence::forget(this);
    internal::Presence::forget(&message_);
    message_->disconnect();
}

// Asks the master, which is not destroyed meanwhile; `otherwise` if there is none or it was destroyed.
template <class Ask>
auto SlaveActivity::ofMaster(Ask&& ask, decltype(ask(std::declval<base::ActivityInterface&>())) otherwise) const {
    const internal::AccessGate::Pass pass(masterGate_);
    return pass ? ask(*master_) : otherwise;
}

bool SlaveActivity::start() {
    if (!activate()) return false;
    // Messages that came while it was stopped have not triggered it.
    if (runner && runner->hasWork()) trigger();
    return true;
}

bool SlaveActivity::activate() {
    const internal::TryFlag mine(changing_);
    if (!mine) return false;
    if (master_ && !ofMaster([](ActivityInterface& master) { return master.isActive(); }, false)) {
        os::detail::log(os::detail::LogError, "SlaveActivity",
                        "cannot start a slave: its master is not active, or has been destroyed");
        return false;
    }
    if (active_) {
        os::detail::log(os::detail::LogError, "SlaveActivity", "cannot start a slave: it is active already");
        return false;
    }
    internal::ActiveWhile active(active_);
    if (!initialize()) return false;
    active.stay();
    updater_ = 0;
    open_ = true;
    return true;
}

bool SlaveActivity::stop() {
    const internal::TryFlag mine(changing_);
    const bool stops = mine && open_.exchange(false);
    // Even if it is not active, because callers of stop() expect that it is not executed afterwards.
    const bool left = waitForExecution(rtos_get_time_ns() + Seconds_to_nsecs(1.0));
    if (!stops) return false;
    if (!left) {
        os::detail::log(os::detail::LogError, "SlaveActivity",
                        "cannot stop a slave: another thread has been executing it for 1 s");
        open_ = true;
        return false;
    }
    const internal::ActiveWhile active(active_);
    finalize();
    updater_ = 0;  // that thread may live on and do other work
    return true;
}

// Waits for an execution in another thread.
bool SlaveActivity::waitForExecution(nsecs deadline) const { return internal::Presence::Waiter(this).wait(deadline); }

bool SlaveActivity::isRunning() const { return open_ && (periodic_ || executor_ != 0); }
bool SlaveActivity::isActive() const { return active_; }

Seconds SlaveActivity::getPeriod() const {
    return ofMaster([](ActivityInterface& master) { return master.getPeriod(); }, period_);
}

bool SlaveActivity::setPeriod(Seconds period) {
    if (master_ || !(period >= 0) || (period != 0.0) != periodic_) return false;
    period_ = period;
    return true;
}

bool SlaveActivity::isPeriodic() const { return periodic_; }
unsigned SlaveActivity::getCpuAffinity() const {
    return ofMaster([](ActivityInterface& master) { return master.getCpuAffinity(); }, ~0u);
}
bool SlaveActivity::setCpuAffinity(unsigned) { return false; }

bool SlaveActivity::isExecutor() const { return executor_ == os::detail::currentTid(); }

// The owner enters and then checks that it still is the owner. A thread that takes over first removes the owner and
// then looks for others inside. So the owner, nearly always the thread that executes, needs no locked instruction.
[[gnu::always_inline]] inline base::ActivityInterface::Direct SlaveActivity::claim(internal::Presence::Place*& place) {
    const int self = os::detail::currentTid();
    if (executor_ == self) return Direct::Granted;
    place = owner_ == self ? &internal::Presence::enter(this) : nullptr;
    if (place && owner_ != self) {
        internal::Presence::leave(*place);
        place = nullptr;
    }
    if (!place) place = takeOver();
    if (!place) return Direct::Refused;
    executor_.store(self, std::memory_order_release);
    return Direct::Entered;
}

// For a step; null if this thread may not make one now.
[[gnu::always_inline]] inline internal::Presence::Place* SlaveActivity::enter() {
    internal::Presence::Place* place = nullptr;
    if (claim(place) != Direct::Entered) return nullptr;
    const int self = os::detail::currentTid();
    if (updater_ != self) updater_ = self;
    return place;
}

// Null if another thread executes.
internal::Presence::Place* SlaveActivity::takeOver() {
    const os::detail::PriorityLock only(handover_);
    const int last = owner_.exchange(0);
    if (internal::Presence::Waiter(this).others()) {
        owner_ = last;
        return nullptr;
    }
    internal::Presence::Place& place = internal::Presence::enter(this);
    owner_ = os::detail::currentTid();
    return &place;
}

// A trigger sets its mark before it looks for an executing thread; that thread calls this when it has finished.
void SlaveActivity::servePending() {
    while (pending_) {
        internal::Presence::Place* const place = enter();
        if (!place) return;
        const Leave atEnd{*this, *place};
        if (pending_.exchange(false) && open_) work(base::RunnableInterface::Trigger);
    }
}

bool SlaveActivity::execute() {
    // Until this thread has looked for triggers: a component that ends itself in the execution leaves its activity to
    // another thread, which destroys it after that.
    const Use use(&message_);
    internal::Presence::Place* const place = enter();
    if (!place) return false;
    bool active = false;
    {
        const Leave atEnd{*this, *place};
        // Read after entering: stop() clears it before it looks for an executing thread, so one of the two sees what
        // the other did.
        active = open_;
        if (active) executeOnce();
    }
    if (pending_) servePending();
    return active;
}

void SlaveActivity::executeOnce() {
    periodic_ ? step() : loop();
    work(base::RunnableInterface::TimeOut);
}

void SlaveActivity::executeTrigger() {
    // Within execute() of this thread, the master executes its messages while the slave waits for something.
    if (isExecutor()) {
        if (open_) work(base::RunnableInterface::Trigger);
        return;
    }
    if (inTurn_ && awaitsTurn()) return;
    pending_ = true;
    servePending();
}

void SlaveActivity::setInTurn(bool inTurn) {
    inTurn_ = inTurn;
    // The messages that awaited the turn are in the queue, so the runner finds them.
    if (!inTurn && runner && runner->hasWork()) trigger();
}

bool SlaveActivity::serve() {
    const Use use(&message_);  // as in execute()
    internal::Presence::Place* const place = enter();
    if (!place) return false;
    bool active = false;
    {
        const Leave atEnd{*this, *place};
        active = open_;
        if (active && runner && runner->hasWork()) work(base::RunnableInterface::Trigger);
    }
    if (pending_) servePending();
    return active;
}

bool SlaveActivity::isSlaveOf(const base::ActivityInterface& master) const {
    return masterGate_ && masterGate_ == master.gate();
}

bool SlaveActivity::trigger() {
    if (!open_) return false;
    // A local copy, because a sequential master executes a step here, which may destroy this object.
    TriggerMessage* const message = message_;
    return ofMaster(
        [message](ActivityInterface& master) {
            base::RunnableInterface* const masterRunner = master.getRunner();
            if (!masterRunner) return false;
            if (!message->claim() || masterRunner->process(message)) return true;
            message->dispose();
            return false;
        },
        false);
}

bool SlaveActivity::timeout() {
    if (inTurn_) return open_;
    // The master cannot be destroyed in its own thread before this returns, so its destructor need not wait for the
    // execution.
    const auto isMaster = [](ActivityInterface& master) {
        const Direct answer = master.beginDirect();
        if (answer != Direct::Entered) return answer == Direct::Granted;
        master.endDirect();
        // While a master makes no steps, the main thread takes the place of its thread, for calls but not for steps.
        const os::ThreadInterface* const thread = master.thread();
        return master.isActive() && thread && thread->isActive();
    };
    if (ofMaster(isMaster, false) && execute()) return true;
    return ofMaster([](ActivityInterface& master) { return master.timeout(); }, false);
}

os::ThreadInterface* SlaveActivity::thread() {
    return ofMaster([](ActivityInterface& master) { return master.thread(); }, os::MainThread::Instance());
}

bool SlaveActivity::isSelf() const {
    const int executing = executor_;
    if (executing != 0) return executing == os::detail::currentTid();
    {
        const internal::AccessGate::Pass pass(masterGate_);
        if (master_ && pass) return master_->isSelf();
    }
    return isUpdater();
}

// Between two executions it belongs to the thread that makes them, unless that thread has ended. So no other thread is
// inside at the next execution.
bool SlaveActivity::isUpdater() const {
    const int updater = updater_;
    if (updater == os::detail::currentTid()) return true;
    return os::MainThread::Instance()->isSelf() && (updater == 0 || !os::detail::threadExists(updater));
}

// Between two executions, this thread only takes the place of the one that makes them, and another thread may begin the
// next one at any moment. So it becomes the executing thread for the time of the call.
base::ActivityInterface::Direct SlaveActivity::beginDirect() {
    if (isExecutor()) return Direct::Granted;
    return isSelf() ? claim(direct_) : Direct::Refused;
}

base::ActivityInterface::Direct SlaveActivity::beginInStead() {
    if (ofMaster([](ActivityInterface& master) { return master.isActive(); }, false))
        return SlaveActivity::beginDirect();
    return claim(direct_);
}

void SlaveActivity::endDirect() {
    { const Leave atEnd{*this, *direct_}; }
    // Called by a destructor; the call is unrelated to triggers of other threads.
    try {
        servePending();
    } catch (const std::exception& e) {
        os::detail::log(os::detail::LogError, "SlaveActivity", std::string("a trigger of a slave threw: ") + e.what());
    } catch (...) {
        os::detail::log(os::detail::LogError, "SlaveActivity", "a trigger of a slave threw");
    }
}

bool SlaveActivity::initialize() { return claimRunner() && (!runner || runner->initialize()); }

void SlaveActivity::step() {
    if (runner) runner->step();
}

void SlaveActivity::loop() { runner ? runner->loop() : step(); }

void SlaveActivity::finalize() {
    if (runner) runner->finalize();
}

void SlaveActivity::work(base::RunnableInterface::WorkReason reason) {
    if (runner) runner->work(reason);
}

}  // namespace RTT::extras
