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

/** May come to any thread: the one that waits is woken. */
void onSignal(int signal) {
    const int kept = errno;
    (signal == SIGWINCH ? resized : resumed) = true;
    const std::uint64_t one = 1;
    const int descriptor = told;
    if (descriptor >= 0 && write(descriptor, &one, sizeof one) < 0) {
        // It is awake then.
    }
    errno = kept;
}

}  // namespace

TerminalSignals::TerminalSignals(int wakes) {
    told = wakes;
    struct sigaction action = {};
    action.sa_handler = onSignal;
    action.sa_flags = SA_RESTART;  // whatever a command or a component waits for
    sigaction(SIGWINCH, &action, &resize_);
    sigaction(SIGCONT, &action, &resume_);
    resized = true;  // since somebody asked for the size, for all that is known
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
