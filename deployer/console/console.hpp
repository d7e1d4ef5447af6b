// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The console without a terminal: lines in, text out.
#ifndef OROFORGE_CONSOLE_CONSOLE_HPP
#define OROFORGE_CONSOLE_CONSOLE_HPP

#include "completion.hpp"
#include "session.hpp"

#include <iosfwd>
#include <string>

namespace OCL::console {

class Console {
public:
    /** `self` is the console's own component, and outlives this; `inputName` stands for the typed text in messages. */
    Console(RTT::TaskContext& self, RTT::TaskContext& component, std::ostream& out, std::ostream& err,
            std::string inputName);

    /** Executes one line: a command, a piece of script, or a part of one. */
    void execute(const std::string& line);
    /** There are no more lines: executes what was begun. */
    void finish();
    /** Forgets a piece of script that was begun. */
    void forget();
    /** Lists what is traced and has moved; then what to show before the next line. */
    std::string prompt();
    Completion complete(const std::string& line) const;

    bool quits() const { return session_.quits; }
    Screen& screen() { return session_.screen; }
    Session& session() { return session_; }

private:
    bool findContext();
    void run(const Input& input);
    bool showNamed(const std::string& name);
    void evaluate(const std::string& text, unsigned line);
    void show(const RTT::scripting::TypedInput::Answer& answer);

    Session session_;
    unsigned line_ = 0;        // number of the last one
    std::string begun_;        // a piece of script that goes on
    unsigned begun_line_ = 0;  // where it began
};

}  // namespace OCL::console

#endif
