// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/engine/deferred_activity.hpp>

#include <rtt/Activity.hpp>

#include <new>

namespace RTT::internal {

namespace {
// A pointer, because thread-local objects are destroyed in no known order.
thread_local const std::string* promised = nullptr;
}  // namespace

ActivityFollows::ActivityFollows(const std::string& component) : component_(component) {
    promised = component_.empty() ? nullptr : &component_;
}

ActivityFollows::~ActivityFollows() { promised = nullptr; }

bool ActivityFollows::take(const std::string& component) {
    if (!promised || *promised != component) return false;
    promised = nullptr;
    return true;
}

/** Executes the runner of the deferred activity, but is not the runner's activity. */
class DeferredActivity::Own : public Activity {
public:
    Own(DeferredActivity& outer, const std::string& name, Seconds period)
        : Activity(ORO_SCHED_OTHER, os::LowestPriority, period, outer.runner, name), outer_(outer) {}
    ~Own() override { stop(); }

    void follow(base::RunnableInterface* newRunner) { adopt(newRunner); }

private:
    bool initialize() override {
        const bool isOuters = runner && runner->getActivity() == &outer_;
        return isOuters ? runner->initialize() : Activity::initialize();
    }

    const DeferredActivity& outer_;
};

DeferredActivity::DeferredActivity(const std::string& name) : name_(name) {}

DeferredActivity::~DeferredActivity() {
    closeGate();
    own_.reset();
}

Activity* DeferredActivity::made(Seconds period) {
    if (Activity* const activity = ifMade()) return activity;
    const std::lock_guard<std::mutex> lock(making_);
    if (!own_) {
        own_ = std::make_unique<Own>(*this, name_, period);
        if (started_) own_->start();
        made_.store(own_.get(), std::memory_order_release);
    }
    return own_.get();
}

bool DeferredActivity::run(base::RunnableInterface* newRunner) {
    const std::lock_guard<std::mutex> lock(making_);
    if (!ActivityInterface::run(newRunner)) return false;
    if (own_) own_->follow(newRunner);
    return true;
}

bool DeferredActivity::start() {
    {
        const std::lock_guard<std::mutex> lock(making_);
        if (!own_) return started_ = true;
    }
    return own_->start();
}

bool DeferredActivity::stop() {
    {
        const std::lock_guard<std::mutex> lock(making_);
        if (!own_) return started_.exchange(false);
    }
    return own_->stop();
}

bool DeferredActivity::isRunning() const { return ifMade() ? ifMade()->isRunning() : started_.load(); }
bool DeferredActivity::isActive() const { return ifMade() ? ifMade()->isActive() : started_.load(); }
Seconds DeferredActivity::getPeriod() const { return ifMade() ? ifMade()->getPeriod() : 0.0; }
bool DeferredActivity::setPeriod(Seconds period) { return made(period)->setPeriod(period); }
unsigned DeferredActivity::getCpuAffinity() const {
    return const_cast<DeferredActivity*>(this)->made()->getCpuAffinity();
}
bool DeferredActivity::setCpuAffinity(unsigned cpuAffinity) { return made()->setCpuAffinity(cpuAffinity); }
bool DeferredActivity::execute() { return false; }

// The sender has queued its message already, so it is executed by the activity that follows.
bool DeferredActivity::trigger() try { return isActive() && made()->trigger(); } catch (const std::bad_alloc&) {
    return false;
}

bool DeferredActivity::timeout() try { return isActive() && made()->timeout(); } catch (const std::bad_alloc&) {
    return false;
}

os::ThreadInterface* DeferredActivity::thread() { return made()->thread(); }
bool DeferredActivity::isSelf() const { return ifMade() && ifMade()->isSelf(); }

}  // namespace RTT::internal
