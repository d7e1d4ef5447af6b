// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "script_end.hpp"

#include <rtt/os/SignalsBlocked.hpp>

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace OCL::deploy {
namespace {

constexpr int kPatience = 2000;  // milliseconds, as for the shutdown of an Application

/** Waits until one of the descriptors can be read, at most `limit` milliseconds; −1 waits for ever. */
void waitFor(pollfd* descriptors, nfds_t count, int limit) {
    while (poll(descriptors, count, limit) < 0 && errno == EINTR) {
    }
}

}  // namespace

ScriptEnd::ScriptEnd(const RTT::os::SignalCatcher& ending) {
    if (pipe2(over_, O_CLOEXEC) != 0)
        throw std::system_error(errno, std::generic_category(), "no pipe to watch scripts with");
    const RTT::os::SignalsBlocked blocked;
    thread_ = std::thread([this, descriptor = ending.descriptor()] { watch(descriptor); });
}

ScriptEnd::~ScriptEnd() {
    close(over_[1]);
    thread_.join();
    close(over_[0]);
}

void ScriptEnd::watch(int ending) {
    pollfd both[] = {{over_[0], POLLIN, 0}, {ending, POLLIN, 0}};
    waitFor(both, 2, -1);
    if (both[0].revents == 0) waitFor(both, 1, kPatience);
    if (both[0].revents == 0) interruption_.ask();
}

}  // namespace OCL::deploy
