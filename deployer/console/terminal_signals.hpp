// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_CONSOLE_TERMINAL_SIGNALS_HPP
#define OROFORGE_CONSOLE_TERMINAL_SIGNALS_HPP

#include <csignal>

namespace OCL::console {

/** While one lives, it is noted that the terminal has got another size, or the process goes on after it was stopped. One at a time. */
class TerminalSignals {
public:
    /** `wakes` is an eventfd that is told. */
    explicit TerminalSignals(int wakes);
    ~TerminalSignals();
    TerminalSignals(const TerminalSignals&) = delete;
    TerminalSignals& operator=(const TerminalSignals&) = delete;

    /** Something came that was not taken yet. */
    bool any() const;
    /** True once for each. */
    bool takeResized();
    bool takeResumed();

private:
    struct sigaction resize_ = {}, resume_ = {};  // what was there before
};

}  // namespace OCL::console

#endif
