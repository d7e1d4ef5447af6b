// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/base/ActivityInterface.hpp>

namespace RTT {
namespace base {

ActivityInterface::ActivityInterface(RunnableInterface* newRunner) { attach(newRunner); }

ActivityInterface::~ActivityInterface() { attach(nullptr); }

void ActivityInterface::attach(RunnableInterface* newRunner) {
    if (runner && runner->getActivity() == this) runner->setActivity(nullptr);
    runner = newRunner;
    if (runner) runner->setActivity(this);
}

bool ActivityInterface::run(RunnableInterface* newRunner) {
    if (isActive() || isRunning()) return false;
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
