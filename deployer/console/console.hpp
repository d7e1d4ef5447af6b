// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The console without a terminal: takes lines and writes text.
#ifndef OROFORGE_CONSOLE_CONSOLE_HPP
#define OROFORGE_CONSOLE_CONSOLE_HPP

#include "completion.hpp"
#include "console_state.hpp"

#include <iosfwd>
#include <string>

namespace OCL::console {

class Console {
public:
    /** `self` is the console's own component and must outlive this; messages call the typed text `inputName`. */
    Console(RTT::TaskContext& self, RTT::TaskContext& component, std::ostream& out, std::ostream& err,
            std::string inputName);

    /** Executes one line: a command, a piece of script, or a part of one. */
    void execute(const std::string& line);
    /** Ends the input: executes what was begun. */
    void finish();
    /** Drops a piece of script that was begun. */
    void forget();
    /** Lists traced programs that have moved, and returns the prompt for the next line. */
    std::string prompt();
    Completion complete(const std::string& line) const;

    bool quits() const { return state_.quits; }
    Screen& screen() { return state_.screen; }
    ConsoleState& state() { return state_; }

private:
    bool findContext();
    void run(const Input& input);
    bool showNamed(const std::string& name);
    void evaluate(const std::string& text, unsigned line);
    void show(const RTT::scripting::TypedInput::Answer& answer);

    ConsoleState state_;
    unsigned line_ = 0;        // number of the last one
    std::string begun_;        // an unfinished piece of script
    unsigned begun_line_ = 0;  // the line where it began
};

}  // namespace OCL::console

#endif
