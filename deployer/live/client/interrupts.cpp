// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "interrupts.hpp"

#include "failure.hpp"

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <iterator>

#include <sys/eventfd.h>
#include <unistd.h>

namespace oroforge::live_client {
namespace {

constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP};

int wake = -1;
volatile std::sig_atomic_t ends = 0;
struct sigaction before[std::size(kSignals)];

void onSignal(int number) {
    const int kept = errno;
    if (number != SIGINT) ends = 1;
    const std::uint64_t one = 1;
    const ssize_t ignored = write(wake, &one, sizeof one);
    static_cast<void>(ignored);
    errno = kept;
}

}  // namespace

Interrupts::Interrupts() {
    wake = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
    if (wake < 0) throw Failure(Status::Refused, "there are no descriptors left; 'ulimit -n' allows more");
    struct sigaction action = {};
    action.sa_handler = onSignal;
    for (std::size_t i = 0; i != std::size(kSignals); ++i) {
        sigaction(kSignals[i], nullptr, &before[i]);
        // A program that nohup or a shell has in the background ignores some of them.
        if (before[i].sa_handler != SIG_IGN) sigaction(kSignals[i], &action, nullptr);
    }
}

Interrupts::~Interrupts() {
    for (std::size_t i = 0; i != std::size(kSignals); ++i) sigaction(kSignals[i], &before[i], nullptr);
    close(wake);
    wake = -1;
}

int Interrupts::descriptor() const { return wake; }

bool Interrupts::take() {
    std::uint64_t count = 0;
    return read(wake, &count, sizeof count) == sizeof count;
}

bool Interrupts::mustEnd() const { return ends != 0; }

}  // namespace oroforge::live_client
