// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The handler does only what is safe in any thread at any point: it writes into a pipe, or ends the process. Another
// thread may still execute it after its object has ended, so the pipe stays open for the next object.
#include "end_signals.hpp"

#include "kept_terminal.hpp"

#include <rtt/os/detail/terminal_flow.hpp>

#include <atomic>
#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace OCL::console {
namespace {

enum State { Nobody, Waits, Told };
std::atomic<int> state{Nobody};
int ends[2];

void makePipe() {
    if (pipe2(ends, O_CLOEXEC | O_NONBLOCK) != 0)
        throw std::system_error(errno, std::generic_category(), "no pipe for signals");
}

void onSignal(int signal);

/** True if the handler is installed, even without an object: code that had replaced it may have put it back. */
bool isOurs(int signal) {
    struct sigaction now = {};
    return sigaction(signal, nullptr, &now) == 0 && !(now.sa_flags & SA_SIGINFO) && now.sa_handler == onSignal;
}

void onSignal(int signal) {
    const int kept = errno;
    RTT::os::detail::letTerminalsWrite();
    const char byte = 0;
    int before = Waits;
    const bool first = state.compare_exchange_strong(before, Told);
    if (!first || write(ends[1], &byte, 1) != 1) {
        // If nothing waits any more, the previous action takes effect.
        if (before != Nobody || isOurs(signal)) {
            restoreTerminal();
            std::signal(signal, SIG_DFL);
        }
        raise(signal);
    }
    errno = kept;
}

}  // namespace

EndSignals::EndSignals() {
    static const bool made = (makePipe(), true);
    (void)made;
    char late;
    while (read(ends[0], &late, 1) == 1) {
    }
    state = Waits;
    struct sigaction action = {};
    action.sa_handler = onSignal;
    sigemptyset(&action.sa_mask);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        Previous previous = {signal, {}};
        if (sigaction(signal, nullptr, &previous.action) != 0) continue;
        if (signal == SIGHUP && previous.action.sa_handler == SIG_IGN) continue;  // ignored, as by nohup
        if (sigaction(signal, &action, nullptr) == 0) previous_.push_back(previous);
    }
}

EndSignals::~EndSignals() {
    for (const Previous& previous : previous_)
        if (isOurs(previous.signal)) sigaction(previous.signal, &previous.action, nullptr);
    state = Nobody;
}

int EndSignals::descriptor() const { return ends[0]; }

}  // namespace OCL::console
