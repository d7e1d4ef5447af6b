// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The handler may only do what is safe in any thread at any point: it writes the number into a pipe.
#include "signals.hpp"

#include <cerrno>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace OCL::deploy {
namespace {

// Of the innermost catcher.
volatile sig_atomic_t readEnd = -1;
volatile sig_atomic_t writeEnd = -1;
volatile sig_atomic_t pending = 0;
volatile sig_atomic_t last = 0;

void onSignal(int signal) {
    const int kept = errno;
    const unsigned char number = static_cast<unsigned char>(signal);
    // A second signal while the first still waits for attention: somebody is losing patience.
    if (pending || write(writeEnd, &number, 1) != 1) {
        ::signal(signal, SIG_DFL);
        raise(signal);
    }
    pending = 1;
    last = signal;
    errno = kept;
}

}  // namespace

SignalCatcher::SignalCatcher(std::initializer_list<int> signals) : outerPipe_{readEnd, writeEnd} {
    if (pipe2(pipe_, O_CLOEXEC) != 0) {
        pipe_[0] = pipe_[1] = -1;
        ready_ = false;
        return;
    }
    fcntl(pipe_[1], F_SETFL, O_NONBLOCK);
    readEnd = pipe_[0];
    writeEnd = pipe_[1];
    struct sigaction action = {};
    action.sa_handler = onSignal;
    sigemptyset(&action.sa_mask);
    for (int signal : signals) {
        Previous previous = {signal, {}};
        if (sigaction(signal, &action, &previous.action) == 0)
            previous_.push_back(previous);
        else
            ready_ = false;
    }
}

SignalCatcher::~SignalCatcher() {
    for (const Previous& previous : previous_) sigaction(previous.signal, &previous.action, nullptr);
    pending = 0;
    readEnd = outerPipe_[0];
    writeEnd = outerPipe_[1];
    close(pipe_[0]);
    close(pipe_[1]);
}

bool SignalCatcher::caught() const {
    pollfd end = {pipe_[0], POLLIN, 0};
    return poll(&end, 1, 0) == 1 && (end.revents & POLLIN) != 0;
}

int SignalCatcher::wait() {
    // One that came before this catcher was there is in the pipe of the outer one, and stays there: it concerns both.
    pollfd ends[] = {{pipe_[0], POLLIN, 0}, {outerPipe_[0], POLLIN, 0}};
    while (poll(ends, 2, -1) < 0 && errno == EINTR) {
    }
    if (ends[1].revents & POLLIN) return last;
    unsigned char number = 0;
    while (read(pipe_[0], &number, 1) < 0 && errno == EINTR) {
    }
    pending = 0;
    return number;
}

}  // namespace OCL::deploy
