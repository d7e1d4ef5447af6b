// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The main thread executes commands and may block anywhere, so a second thread waits for Ctrl-C. The handler does only
// what is safe in any thread at any point: it wakes that thread, or ends the process. Another thread may still execute
// it after the object has ended, so its descriptor stays open.
#include "interrupts.hpp"

#include "kept_terminal.hpp"

#include <rtt/os/SignalsBlocked.hpp>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <iostream>
#include <system_error>

#include <poll.h>
#include <sys/eventfd.h>
#include <termios.h>
#include <unistd.h>

namespace OCL::console {
namespace {

// Milliseconds until a command counts as one that cannot be stopped; scripts and calls end much sooner.
constexpr std::int64_t kPatience = 1000;

std::atomic<bool> watching{false}, executing{false}, ends{false};
int pressed = -1;
struct sigaction before;

int newDescriptor() {
    const int made = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
    if (made < 0) throw std::system_error(errno, std::generic_category(), "no descriptor for the console");
    return made;
}

void notify(int descriptor) {
    const std::uint64_t one = 1;
    while (write(descriptor, &one, sizeof one) < 0 && errno == EINTR) {
    }
}

/** Shows that Ctrl-C was seen; the terminal may have shown the key itself. */
void acknowledge() {
    termios mode = {};
    if (tcgetattr(STDIN_FILENO, &mode) != 0) return;
    std::cerr << ((mode.c_lflag & ECHO) ? "" : "^C") << std::endl;
}

bool wasNotified(int descriptor) {
    std::uint64_t count = 0;
    return read(descriptor, &count, sizeof count) > 0;
}

void onInterrupt(int signal, siginfo_t* info, void*) {
    const int kept = errno;
    const bool key = info->si_code > 0;  // otherwise a process sent it
    if (ends) {
        restoreTerminal();
        std::signal(signal, SIG_DFL);
        raise(signal);
    } else if (watching && (key || executing)) {
        notify(pressed);
    } else {
        sigaction(signal, &before, nullptr);
        raise(signal);
    }
    errno = kept;
}

bool isOurs(const struct sigaction& action) {
    return (action.sa_flags & SA_SIGINFO) && action.sa_sigaction == onInterrupt;
}

/** Installs the handler of SIGINT, unless the signal is ignored, as in background jobs of some shells. */
void takeOver() {
    struct sigaction previous = {};
    if (sigaction(SIGINT, nullptr, &previous) != 0 || isOurs(previous)) return;
    if (!(previous.sa_flags & SA_SIGINFO) && previous.sa_handler == SIG_IGN) return;
    before = previous;
    struct sigaction action = {};
    action.sa_sigaction = onInterrupt;
    action.sa_flags = SA_SIGINFO | SA_RESTART;  // so that system calls of the command go on
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, nullptr);
}

void giveBack() {
    struct sigaction now = {};
    if (sigaction(SIGINT, nullptr, &now) == 0 && isOurs(now)) sigaction(SIGINT, &before, nullptr);
}

std::int64_t now() {
    using namespace std::chrono;
    return duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Interrupts::Interrupts(int endsOn, bool onTerminal)
    : ends_on_(endsOn), on_terminal_(onTerminal), wakes_(newDescriptor()) {
    static const int made = newDescriptor();
    pressed = made;
    watching = true;
    if (on_terminal_) takeOver();
    const RTT::os::SignalsBlocked blocked;
    thread_ = std::thread([this] { watch(); });
}

Interrupts::~Interrupts() {
    {
        const std::lock_guard<std::mutex> locked(mutex_);
        over_ = true;
    }
    notify(wakes_);
    thread_.join();
    watching = false;  // other code may have saved the handler, and may put it back later
    if (on_terminal_) giveBack();
    close(wakes_);
}

Interrupts::Command::Command(Interrupts& interrupts) : of_(interrupts), interruption_(interrupts.on_terminal_) {
    const std::lock_guard<std::mutex> locked(of_.mutex_);
    of_.command_ = &interruption_;
    if (of_.on_terminal_) {
        executing = true;
        takeOver();  // a library that was loaded may have replaced the handler
    }
    if (of_.ends_) of_.interrupt();
    notify(of_.wakes_);
}

Interrupts::Command::~Command() {
    const std::lock_guard<std::mutex> locked(of_.mutex_);
    of_.command_ = nullptr;
    of_.tells_ = -1;
    executing = ends = false;
}

/** Milliseconds until the user must be warned; −1 for never. */
int Interrupts::patience() const {
    return tells_ < 0 ? -1 : static_cast<int>(std::max<std::int64_t>(tells_ - now(), 0));
}

void Interrupts::watch() {
    std::unique_lock<std::mutex> lock(mutex_);
    while (!over_) {
        // A key between two commands counts for the second one, unless forgetInterrupts() is called.
        pollfd all[] = {{wakes_, POLLIN, 0}, {ends_ ? -1 : ends_on_, POLLIN, 0}, {command_ ? pressed : -1, POLLIN, 0}};
        const int left = patience();
        lock.unlock();
        const int ready = poll(all, 3, left);
        lock.lock();
        if (ready < 0) continue;  // EINTR
        if (all[0].revents != 0) (void)wasNotified(wakes_);
        if (all[1].revents != 0) {
            ends_ = true;
            interrupt();
        }
        if (all[2].revents != 0 && command_ && wasNotified(pressed) && !command_->asked()) {
            acknowledge();
            interrupt();
        }
        if (tells_ >= 0 && patience() == 0) tell();
    }
}

/** Asks the command to stop. The mutex is locked, as for tell(). */
void Interrupts::interrupt() {
    if (!command_ || command_->asked()) return;
    command_->ask();
    tells_ = now() + kPatience;
}

/** Warns the user that the command is still being executed. */
void Interrupts::tell() {
    tells_ = -1;
    if (!on_terminal_) return;
    ends = true;
    std::cerr << "this command executes C++ code, which cannot be stopped; "
              << (ends_ ? "the console is left once it is done, and Ctrl-C" : "another Ctrl-C")
              << " ends the process at once" << std::endl;
    if (ends_) restoreTerminal();  // because it is too late when another signal ends the process
}

void forgetInterrupts() {
    if (pressed >= 0) (void)wasNotified(pressed);
}

}  // namespace OCL::console
