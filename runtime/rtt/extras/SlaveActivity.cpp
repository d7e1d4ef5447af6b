// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/extras/SlaveActivity.hpp>

#include <rtt/base/DisposableInterface.hpp>
#include <rtt/os/MainThread.hpp>
#include <rtt/os/MutexLock.hpp>
#include <rtt/os/detail/futex.hpp>
#include <rtt/os/detail/os_log.hpp>

namespace RTT {
namespace extras {

/**
 * The one message of a slave, made once so that trigger() allocates nothing. It is in the queue of the master at
 * most once, and may still be there when the slave is destroyed: both own it.
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
        {
            os::MutexLock lock(mutex_);
            if (slave_) slave_->executeTrigger();
        }
        release();
    }
    void dispose() override {
        queued_.exchange(false, std::memory_order_acq_rel);
        release();
    }
    bool isError() const override { return false; }

private:
    void release() {
        if (owners_.fetch_sub(1, std::memory_order_acq_rel) == 1) delete this;
    }

    os::MutexRecursive mutex_;  // recursive: the slave may be destroyed from within its work
    SlaveActivity* slave_;
    std::atomic<bool> queued_{false};
    std::atomic<int> owners_{1};
};

SlaveActivity::SlaveActivity(base::ActivityInterface* master, base::RunnableInterface* r)
    : base::ActivityInterface(r),
      master_(master),
      period_(master ? master->getPeriod() : 0.0),
      periodic_(period_ != 0.0),
      message_(new TriggerMessage(this)) {}

SlaveActivity::SlaveActivity(double period, base::RunnableInterface* r)
    : base::ActivityInterface(r),
      master_(nullptr),
      period_(period),
      periodic_(period != 0.0),
      message_(new TriggerMessage(this)) {}

SlaveActivity::SlaveActivity(base::RunnableInterface* r) : SlaveActivity(0.0, r) {}

SlaveActivity::~SlaveActivity() {
    stop();
    message_->disconnect();
}

bool SlaveActivity::start() {
    if (master_ && !master_->isActive()) {
        os::detail::log(os::detail::LogError, "SlaveActivity", "cannot start a slave: its master is not active");
        return false;
    }
    if (active_) {
        os::detail::log(os::detail::LogError, "SlaveActivity", "cannot start a slave: it is active already");
        return false;
    }
    if (runner && !runner->initialize()) return false;
    active_ = true;
    return true;
}

bool SlaveActivity::stop() {
    if (!active_.exchange(false)) return false;
    if (runner) runner->finalize();
    return true;
}

bool SlaveActivity::isRunning() const { return active_ && (periodic_ || executor_ != 0); }
bool SlaveActivity::isActive() const { return active_; }
Seconds SlaveActivity::getPeriod() const { return master_ ? master_->getPeriod() : period_; }

bool SlaveActivity::setPeriod(Seconds period) {
    if (master_ || !(period >= 0) || (period != 0.0) != periodic_) return false;
    period_ = period;
    return true;
}

bool SlaveActivity::isPeriodic() const { return periodic_; }
unsigned SlaveActivity::getCpuAffinity() const { return master_ ? master_->getCpuAffinity() : ~0u; }
bool SlaveActivity::setCpuAffinity(unsigned) { return false; }

bool SlaveActivity::enter() {
    int nobody = 0;
    return executor_.compare_exchange_strong(nobody, os::detail::currentTid());
}

// A trigger that found another thread executing left its mark before it looked; that thread comes here when it is done.
void SlaveActivity::servePending() {
    while (pending_ && enter()) {
        if (pending_.exchange(false) && active_ && runner) runner->work(base::RunnableInterface::Trigger);
        executor_ = 0;
    }
}

bool SlaveActivity::execute() {
    if (!active_ || !enter()) return false;
    struct Leave {
        SlaveActivity& slave;
        ~Leave() { slave.executor_ = 0; }
    };
    {
        Leave atEnd{*this};  // also when the component throws
        if (runner) {
            periodic_ ? runner->step() : runner->loop();
            runner->work(base::RunnableInterface::TimeOut);
        }
    }
    servePending();
    return true;
}

void SlaveActivity::executeTrigger() {
    // Within execute() of this thread: the master executes its messages while the slave waits for something.
    if (executor_ == os::detail::currentTid()) {
        if (active_ && runner) runner->work(base::RunnableInterface::Trigger);
        return;
    }
    pending_ = true;
    servePending();
}

bool SlaveActivity::trigger() {
    base::RunnableInterface* const masterRunner = master_ ? master_->getRunner() : nullptr;
    if (!active_ || !masterRunner) return false;
    if (!message_->claim() || masterRunner->process(message_)) return true;
    message_->dispose();
    return false;
}

bool SlaveActivity::timeout() { return master_ && master_->timeout(); }

os::ThreadInterface* SlaveActivity::thread() { return master_ ? master_->thread() : os::MainThread::Instance(); }

bool SlaveActivity::isSelf() const {
    const int executor = executor_;
    if (executor != 0) return executor == os::detail::currentTid();
    return master_ ? master_->isSelf() : os::MainThread::Instance()->isSelf();
}

}  // namespace extras
}  // namespace RTT
