// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/orb_run.hpp>

#include <cerrno>
#include <cstdint>
#include <system_error>

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

namespace RTT::corba::detail {

namespace {

/** Readable when the run has ended. */
int ended() {
    static const int event = [] {
        const int made = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
        if (made == -1) throw std::system_error(errno, std::generic_category(), "no event to wait for the ORB with");
        return made;
    }();
    return event;
}

}  // namespace

void waitForEndOfRun(int descriptor) {
    pollfd both[] = {{ended(), POLLIN, 0}, {descriptor, POLLIN, 0}};  // poll() ignores negative descriptors
    while (poll(both, 2, -1) < 0 && errno == EINTR) {
    }
}

void endRun() {
    const std::uint64_t one = 1;
    while (write(ended(), &one, sizeof one) < 0 && errno == EINTR) {
    }
}

void beginRun() {
    std::uint64_t count = 0;
    while (read(ended(), &count, sizeof count) < 0 && errno == EINTR) {
    }
}

}  // namespace RTT::corba::detail
