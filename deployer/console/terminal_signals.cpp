// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "terminal_signals.hpp"

#include <atomic>
#include <cerrno>
#include <cstdint>

#include <unistd.h>

namespace OCL::console {
namespace {

std::atomic<bool> resized{false}, resumed{false};
std::atomic<int> told{-1};

/** Wakes the thread that waits, because any thread may get the signal. */
void onSignal(int signal) {
    const int kept = errno;
    (signal == SIGWINCH ? resized : resumed) = true;
    const std::uint64_t one = 1;
    const int descriptor = told;
    if (descriptor >= 0 && write(descriptor, &one, sizeof one) < 0) {
        // The counter is full, so the thread is awake.
    }
    errno = kept;
}

}  // namespace

TerminalSignals::TerminalSignals(int wakes) {
    told = wakes;
    struct sigaction action = {};
    action.sa_handler = onSignal;
    action.sa_flags = SA_RESTART;  // so that system calls of commands and components go on
    sigaction(SIGWINCH, &action, &resize_);
    sigaction(SIGCONT, &action, &resume_);
    resized = true;  // the size may have changed since it was last read
}

TerminalSignals::~TerminalSignals() {
    sigaction(SIGWINCH, &resize_, nullptr);
    sigaction(SIGCONT, &resume_, nullptr);
    told = -1;
}

bool TerminalSignals::any() const { return resized || resumed; }
bool TerminalSignals::takeResized() { return resized.exchange(false); }
bool TerminalSignals::takeResumed() { return resumed.exchange(false); }

}  // namespace OCL::console
