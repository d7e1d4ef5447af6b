// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_CONSOLE_TERMINAL_SIGNALS_HPP
#define OROFORGE_CONSOLE_TERMINAL_SIGNALS_HPP

#include <csignal>

namespace OCL::console {

/** Notes that the terminal was resized, or that the process goes on after a stop. Only one may exist at a time. */
class TerminalSignals {
public:
    /** `wakes` is an eventfd, written at each such signal. */
    explicit TerminalSignals(int wakes);
    ~TerminalSignals();
    TerminalSignals(const TerminalSignals&) = delete;
    TerminalSignals& operator=(const TerminalSignals&) = delete;

    /** True if something was noted and not taken yet. */
    bool any() const;
    /** True once after a change of the size. */
    bool takeResized();
    bool takeResumed();

private:
    struct sigaction resize_ = {}, resume_ = {};  // the previous actions
};

}  // namespace OCL::console

#endif
