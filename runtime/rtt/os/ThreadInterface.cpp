// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/os/ThreadInterface.hpp>

#include <rtt/os/detail/thread_list.hpp>
#include <rtt/os/futex.hpp>

namespace RTT::os {

ThreadInterface::~ThreadInterface() { delist(); }

bool ThreadInterface::isSelf() const { return getTask()->pid == detail::currentTid(); }

void ThreadInterface::enlist(const char* name, unsigned pid) { number_ = detail::addThread(name, pid); }

void ThreadInterface::delist() {
    if (number_ >= 0) detail::removeThread(number_);
    number_ = -1;
}

}  // namespace RTT::os
