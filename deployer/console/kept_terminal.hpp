// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_CONSOLE_KEPT_TERMINAL_HPP
#define OROFORGE_CONSOLE_KEPT_TERMINAL_HPP

#include <csignal>
#include <vector>

namespace OCL::console {

/**
 * Saves the mode of the terminal of standard input before a line editor changes it, and restores it in the destructor,
 * at exit(), in a crash or at another signal that ends the process, and while Ctrl-Z stops the process. It cannot do so
 * at SIGKILL, _exit() and an overflow of the stack. Only one may exist at a time.
 */
class KeptTerminal {
public:
    KeptTerminal();
    ~KeptTerminal();
    KeptTerminal(const KeptTerminal&) = delete;
    KeptTerminal& operator=(const KeptTerminal&) = delete;

private:
    void handle(int signal, void (*handler)(int, siginfo_t*, void*), int flags);

    std::vector<int> handled_;  // signals
};

// Any thread and signal handlers may call these.
/** Restores the terminal if there is a KeptTerminal and the process may set it. */
void restoreTerminal();
/** True if there is a KeptTerminal and the process is not in the background, where setting the terminal would stop
    it. */
bool maySetTerminal();

/** Sequences that make the terminal mark where pasted text begins and ends, or end that. */
constexpr char kMarkPaste[] = "\033[?2004h", kUnmarkPaste[] = "\033[?2004l";
/** Records which of the two was sent. */
void setPasteMarked(bool marked);

}  // namespace OCL::console

#endif
