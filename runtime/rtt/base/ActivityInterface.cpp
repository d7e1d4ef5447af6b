// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/base/ActivityInterface.hpp>

#include <rtt/internal/AccessGate.hpp>

namespace RTT {
namespace base {

ActivityInterface::ActivityInterface() : gate_(std::make_shared<internal::AccessGate>()) {}

ActivityInterface::ActivityInterface(RunnableInterface* newRunner) : ActivityInterface() { attach(newRunner); }

ActivityInterface::~ActivityInterface() {
    closeGate();
    attach(nullptr);
}

void ActivityInterface::closeGate() noexcept {
    gateClosed_ = true;
    gate_->close();
}

void ActivityInterface::attach(RunnableInterface* newRunner) {
    // A slave may be about to hand a message to the present runner, which may be destroyed after this.
    gate_->close();
    if (runner && runner->getActivity() == this) runner->setActivity(nullptr);
    runner = newRunner;
    if (runner) runner->setActivity(this);
    if (!gateClosed_) gate_->open();
}

bool ActivityInterface::run(RunnableInterface* newRunner) {
    // Within its own step a stopped one may lose its runner, which is being destroyed there.
    if (isActive() || (isRunning() && (newRunner || !isSelf()))) return false;
    attach(newRunner);
    return true;
}

bool ActivityInterface::isPeriodic() const { return getPeriod() != 0.0; }

bool ActivityInterface::isSelf() const {
    // thread() is not const in the RTT API, yet changes nothing.
    const os::ThreadInterface* const thread = const_cast<ActivityInterface*>(this)->thread();
    return thread && thread->isSelf();
}

}  // namespace base
}  // namespace RTT
