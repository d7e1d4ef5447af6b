// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "end_notice.hpp"

#include "kept_terminal.hpp"
#include "line_source.hpp"

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <iostream>
#include <system_error>

#include <sys/eventfd.h>
#include <unistd.h>

namespace OCL::console {

EndNotice::EndNotice(int endsOn) : over_(eventfd(0, EFD_CLOEXEC)) {
    if (over_ < 0) throw std::system_error(errno, std::generic_category(), "no descriptor for the console");
    // Signals are for the threads that were there before.
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    thread_ = std::thread([this, endsOn] { watch(endsOn); });
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

EndNotice::~EndNotice() {
    const std::uint64_t one = 1;
    while (write(over_, &one, sizeof one) < 0 && errno == EINTR) {
    }
    thread_.join();
    close(over_);
}

void EndNotice::executing(bool yes) {
    executing_ = yes;
    tell();
}

void EndNotice::watch(int endsOn) {
    if (waitForInput(over_, endsOn) != Wake::End) return;
    ends_ = true;
    tell();
}

// By whichever comes second: the signal, or the command that was typed before it and begins only now.
void EndNotice::tell() {
    if (!ends_ || !executing_ || told_.exchange(true)) return;
    restoreTerminal();  // nothing is left to do that when the second one ends the process
    std::cerr << "\nthe console is left once this command is done; a second Ctrl-C ends the process at once\n";
}

}  // namespace OCL::console
