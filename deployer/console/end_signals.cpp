// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The handler may only do what is safe in any thread at any point: it writes into a pipe.
#include "end_signals.hpp"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace OCL::console {
namespace {

volatile sig_atomic_t writeEnd = -1;

void onSignal(int signal) {
    const int kept = errno;
    const char byte = 0;
    const int end = writeEnd;
    writeEnd = -1;
    if (end < 0 || write(end, &byte, 1) != 1) {
        std::signal(signal, SIG_DFL);
        raise(signal);
    }
    errno = kept;
}

}  // namespace

EndSignals::EndSignals() {
    if (pipe2(pipe_, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "no pipe for signals");
    fcntl(pipe_[1], F_SETFL, O_NONBLOCK);
    writeEnd = pipe_[1];
    struct sigaction action = {};
    action.sa_handler = onSignal;
    sigemptyset(&action.sa_mask);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        Previous previous = {signal, {}};
        if (sigaction(signal, &action, &previous.action) == 0) previous_.push_back(previous);
    }
}

EndSignals::~EndSignals() {
    for (const Previous& previous : previous_) sigaction(previous.signal, &previous.action, nullptr);
    writeEnd = -1;
    close(pipe_[0]);
    close(pipe_[1]);
}

}  // namespace OCL::console
