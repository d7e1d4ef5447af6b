// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/base/ActivityInterface.hpp>

#include <rtt/Logger.hpp>
#include <rtt/internal/engine/access_gate.hpp>

namespace RTT::base {

ActivityInterface::ActivityInterface() : gate_(std::make_shared<internal::AccessGate>()) {}

ActivityInterface::ActivityInterface(RunnableInterface* newRunner) : ActivityInterface() { adopt(newRunner); }

ActivityInterface::~ActivityInterface() {
    closeGate();
    attach(nullptr);
}

const std::shared_ptr<internal::AccessGate>& ActivityInterface::gate() const {
    gate_->share();
    return gate_;
}

void ActivityInterface::closeGate() noexcept {
    gateClosed_ = true;
    gate_->closeForGood();
}

void ActivityInterface::attach(RunnableInterface* newRunner) {
    // A slave may be about to hand a message to the current runner, which may be destroyed after this.
    gate_->close();
    // A runner that another activity took may have been destroyed since.
    if (attached_ && runner->getActivity() == this) runner->setActivity(nullptr);
    if (ActivityInterface* const other = newRunner ? newRunner->getActivity() : nullptr) other->attached_ = false;
    runner = newRunner;
    attached_ = runner != nullptr;
    if (runner) runner->setActivity(this);
    if (!gateClosed_) gate_->open();
}

void ActivityInterface::adopt(RunnableInterface* newRunner) {
    if (newRunner && newRunner->getActivity())
        runner = newRunner;
    else
        attach(newRunner);
}

// A thread that only acts as the executing one is not within a step.
bool ActivityInterface::isWithin() {
    const Direct answer = beginDirect();
    if (answer == Direct::Entered) endDirect();
    return answer == Direct::Granted && isRunning();
}

bool ActivityInterface::claimRunner() {
    ActivityInterface* const other = runner ? runner->getActivity() : this;
    if (other == this) return true;
    // If it were stopped within its own step, it would execute until that returns.
    const bool within = other && other->isWithin();
    if (within || (other && other->isActive() && !other->stop() && other->isActive())) {
        log(Error) << "cannot start an activity: what it is to execute belongs to another one, "
                   << (within ? "whose thread calls start()" : "which does not stop") << endlog();
        return false;
    }
    attach(runner);
    return true;
}

bool ActivityInterface::run(RunnableInterface* newRunner) {
    // A stopped activity may lose its runner within its own step, which is destroying it.
    if (isActive() || (isRunning() && (newRunner || !isSelf()))) return false;
    attach(newRunner);
    return true;
}

ActivityInterface::Direct ActivityInterface::beginDirect() { return isSelf() ? Direct::Granted : Direct::Refused; }
ActivityInterface::Direct ActivityInterface::beginInStead() { return beginDirect(); }
void ActivityInterface::endDirect() {}

bool ActivityInterface::isPeriodic() const { return getPeriod() != 0.0; }

bool ActivityInterface::isSelf() const {
    // thread() is not const in the RTT API, yet changes nothing.
    const os::ThreadInterface* const thread = const_cast<ActivityInterface*>(this)->thread();
    return thread && thread->isSelf();
}

}  // namespace RTT::base
