// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_CONSOLE_KEPT_TERMINAL_HPP
#define OROFORGE_CONSOLE_KEPT_TERMINAL_HPP

#include <csignal>
#include <vector>

namespace OCL::console {

/**
 * Remembers what the terminal of standard input is like when this is made, before a line editor changes it. It is put back at the
 * end, also if that is exit(), a crash or another signal that nobody else handles, and while the process is stopped by Ctrl-Z; not
 * by SIGKILL, _exit() and an overflow of the stack. One at a time.
 */
class KeptTerminal {
public:
    KeptTerminal();
    ~KeptTerminal();
    KeptTerminal(const KeptTerminal&) = delete;
    KeptTerminal& operator=(const KeptTerminal&) = delete;

private:
    struct Previous {
        int signal;
        struct sigaction action;
    };
    void handle(int signal, void (*handler)(int, siginfo_t*, void*), int flags);

    std::vector<Previous> previous_;
};

// Any thread, and signal handlers.
/** Puts the terminal back if there is a KeptTerminal and the process may. */
void restoreTerminal();
/** There is a KeptTerminal, and whoever sets the terminal is not stopped for being in the background. */
bool maySetTerminal();

/** A terminal may tell where pasted text begins and ends. */
constexpr char kTellPaste[] = "\033[?2004h", kTellNoPaste[] = "\033[?2004l";
/** It was told to, or not to any more. */
void tellsPaste(bool tells);

}  // namespace OCL::console

#endif
