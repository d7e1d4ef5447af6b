// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The handler does only what is safe in any thread at any point: it writes the number into a pipe.
#include <rtt/os/SignalCatcher.hpp>

#include <rtt/os/terminal_flow.hpp>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <mutex>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace RTT::os {
namespace {

std::mutex chain;  // guards the chain of catchers; the handler does not lock it
SignalCatcher* innermost = nullptr;
// Set before a handler can see it.
std::atomic<SignalCatcher*> catcherOf[NSIG];
std::atomic<int> handling{0};  // threads within the handler
std::atomic<void (*)()> beforeSecond{nullptr};

bool ends(int signal) { return signal == SIGINT || signal == SIGTERM || signal == SIGHUP; }

}  // namespace

void SignalCatcher::onSignal(int signal) {
    const int kept = errno;
    if (ends(signal)) detail::letTerminalsWrite();
    const unsigned char number = static_cast<unsigned char>(signal);
    // seq_cst, like the end of a catcher: either that sees this handler and waits, or this sees that the catcher is
    // gone.
    handling.fetch_add(1);
    SignalCatcher* const catcher = catcherOf[signal];
    // A second signal before the first one was handled means that the user loses patience.
    const bool second = catcher && catcher->caught_.exchange(signal) != 0;  // before somebody can read it
    // If the last catcher has ended, the previous action takes effect, unless other code has installed this handler
    // again.
    struct sigaction now = {};
    const bool dies = catcher ? second || write(catcher->pipe_[1], &number, 1) != 1
                              : sigaction(signal, nullptr, &now) == 0 && now.sa_handler == &onSignal;
    void (*const atFirst)() = catcher ? catcher->atFirst_.load() : nullptr;
    if (!dies && atFirst) atFirst();
    if (dies) {
        if (void (*const action)() = beforeSecond) action();
        ::signal(signal, SIG_DFL);
    }
    if (dies || !catcher) raise(signal);
    handling.fetch_sub(1);
    errno = kept;
}

void beforeSecondSignal(void (*action)()) { beforeSecond = action; }

int pendingSignal() {
    const std::lock_guard<std::mutex> lock(chain);
    for (const SignalCatcher* catcher = innermost; catcher; catcher = catcher->outer_) {
        const int caught = catcher->caught_;
        if (ends(caught)) return caught;
    }
    return 0;
}

bool SignalCatcher::catchesEnd() const {
    return std::any_of(previous_.begin(), previous_.end(), [](const Previous& one) { return ends(one.signal); });
}

SignalCatcher::SignalCatcher(std::initializer_list<int> signals) {
    const std::lock_guard<std::mutex> lock(chain);
    outer_ = innermost;
    innermost = this;
    if (pipe2(pipe_, O_CLOEXEC) != 0) {
        pipe_[0] = pipe_[1] = -1;
        ready_ = false;
        return;
    }
    fcntl(pipe_[1], F_SETFL, O_NONBLOCK);
    struct sigaction action = {};
    action.sa_handler = &onSignal;
    sigemptyset(&action.sa_mask);
    for (int signal : signals) {
        Previous previous = {signal, nullptr, {}};
        if (signal <= 0 || signal >= NSIG || sigaction(signal, nullptr, &previous.action) != 0) {
            ready_ = false;
            continue;
        }
        if (signal == SIGHUP && previous.action.sa_handler == SIG_IGN) continue;  // ignored, as by nohup
        previous.catcher = catcherOf[signal];
        catcherOf[signal] = this;
        if (sigaction(signal, &action, nullptr) == 0) {
            previous_.push_back(previous);
        } else {
            catcherOf[signal] = previous.catcher;
            ready_ = false;
        }
    }
}

SignalCatcher::~SignalCatcher() {
    const std::lock_guard<std::mutex> lock(chain);
    for (const Previous& previous : previous_) {
        if (catcherOf[previous.signal] == this) {
            // An outer catcher has the same handler. If there is none, the handler is removed before its entry in the
            // table.
            sigaction(previous.signal, &previous.action, nullptr);
            catcherOf[previous.signal] = previous.catcher;
            continue;
        }
        for (SignalCatcher* later = innermost; later != this; later = later->outer_)
            for (Previous& theirs : later->previous_)
                if (theirs.signal == previous.signal && theirs.catcher == this) theirs = previous;
    }
    SignalCatcher** place = &innermost;
    while (*place != this) place = &(*place)->outer_;
    *place = outer_;
    // Another thread may still execute the handler with this catcher; it needs no lock to end.
    while (handling != 0) std::this_thread::sleep_for(std::chrono::microseconds(50));
    close(pipe_[0]);
    close(pipe_[1]);
}

int SignalCatcher::wait() {
    for (bool own = false; !own;) {
        std::vector<pollfd> watched = {{pipe_[0], POLLIN, 0}};
        {
            const std::lock_guard<std::mutex> lock(chain);
            for (const SignalCatcher* catcher = outer_; catcher; catcher = catcher->outer_)
                if (catcher->catchesEnd()) watched.push_back({catcher->pipe_[0], POLLIN, 0});
        }
        if (poll(watched.data(), watched.size(), -1) < 0) continue;  // EINTR
        own = (watched.front().revents & POLLIN) != 0;
        // A signal that an outer catcher has caught concerns both, so it stays there.
        if (const int ending = own ? 0 : pendingSignal()) return ending;
    }
    caught_ = 0;  // from here on, another signal does not end the program
    unsigned char number = 0;
    while (read(pipe_[0], &number, 1) < 0 && errno == EINTR) {
    }
    return number;
}

}  // namespace RTT::os
