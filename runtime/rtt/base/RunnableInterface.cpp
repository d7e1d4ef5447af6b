// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/base/RunnableInterface.hpp>

#include <rtt/base/ActivityInterface.hpp>

namespace RTT::base {

RunnableInterface::RunnableInterface() = default;

RunnableInterface::~RunnableInterface() {
    if (owner_task) owner_task->run(nullptr);
}

void RunnableInterface::work(WorkReason) {}
void RunnableInterface::loop() { step(); }
bool RunnableInterface::breakLoop() { return false; }
bool RunnableInterface::hasWork() { return false; }
bool RunnableInterface::process(DisposableInterface*) { return false; }

os::ThreadInterface* RunnableInterface::getThread() const { return owner_task ? owner_task->thread() : nullptr; }
ActivityInterface* RunnableInterface::getActivity() const { return owner_task; }
void RunnableInterface::setActivity(ActivityInterface* activity) { owner_task = activity; }

}  // namespace RTT::base
