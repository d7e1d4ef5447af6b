// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "lua_prompt.hpp"

#include "../console/history.hpp"
#include "../console/kept_terminal.hpp"
#include "../console/line_editor.hpp"
#include "../lua/complete.hpp"

#include <rtt/os/SignalCatcher.hpp>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <utility>

#include <unistd.h>

namespace OCL::deploy {
namespace {

using console::LineSource;

/** Lines of standard input that is no terminal. Takes no more than it returns: Lua code may read what follows. */
class PipedLines final : public LineSource {
public:
    explicit PipedLines(int endsOn) : endsOn_(endsOn) { std::setvbuf(stdin, nullptr, _IONBF, 0); }
    Outcome read(const std::string& prompt, std::string& line) override {
        std::fputs(prompt.c_str(), stdout);
        std::fflush(stdout);
        line.clear();
        for (;;) {
            const console::Wake woken = console::waitForInput(STDIN_FILENO, endsOn_);
            if (woken == console::Wake::Signal) continue;
            const int letter = woken == console::Wake::End ? EOF : std::getc(stdin);
            if (letter == EOF && line.empty()) std::fputc('\n', stdout);
            if (letter == EOF) return line.empty() ? Outcome::End : Outcome::Line;
            if (letter == '\n') return Outcome::Line;
            line += static_cast<char>(letter);
        }
    }

private:
    const int endsOn_;
};

std::string luaHistoryFile() {
    constexpr const char* kVariable = "ORO_LUA_HISTFILE";
    if (std::getenv(kVariable)) return console::fileNamedBy(kVariable);
    const char* const home = std::getenv("HOME");
    return home ? std::string(home) + "/.rttlua_history" : "";
}

class Prompt {
public:
    Prompt(lua::Interpreter& interpreter, LineSource& source) : interpreter_(interpreter), source_(source) {}

    /** False at the end of the input. */
    bool read(std::string& statement) {
        for (;;) {
            LineSource::Outcome outcome = next("_PROMPT", "> ", statement);
            if (!statement.empty() && statement[0] == '=') statement = "return " + statement.substr(1);
            while (outcome == LineSource::Outcome::Line && interpreter_.goesOn(statement)) {
                std::string line;
                outcome = next("_PROMPT2", ">> ", line);
                statement += '\n' + line;
            }
            if (outcome != LineSource::Outcome::Dropped) return outcome == LineSource::Outcome::Line;
        }
    }

private:
    LineSource::Outcome next(const char* variable, const char* otherwise, std::string& line) {
        const std::string prompt = interpreter_.prompt(variable, otherwise);
        const lua::State::Leave leave(interpreter_.state());
        return source_.read(prompt, line);
    }

    lua::Interpreter& interpreter_;
    LineSource& source_;
};

}  // namespace

void promptForLua(lua::Interpreter& interpreter, console::Interrupts& interrupts, int endsOn) {
    std::unique_ptr<LineSource> source;
    const bool edits = isatty(STDIN_FILENO) && isatty(STDOUT_FILENO);
    console::History history(edits ? luaHistoryFile() : "");
    if (edits) {
        const auto complete = [&interpreter](const std::string& line) {
            lua::Completed found = lua::complete(interpreter.state(), line);
            return console::Completion{found.begin, std::move(found.words), std::move(found.behind)};
        };
        source = std::make_unique<console::LineEditor>(history, complete, endsOn, console::LineEditor::Echo::Always);
        RTT::os::beforeSecondSignal(&console::restoreTerminal);
        if (const std::string problem = history.problem(); !problem.empty()) interpreter.complain(problem);
    } else {
        source = std::make_unique<PipedLines>(endsOn);
    }
    Prompt prompt(interpreter, *source);
    for (std::string statement; prompt.read(statement);) {
        bool interrupted = false;
        {
            const console::Interrupts::Command command(interrupts);
            interpreter.typed(statement);
            interrupted = command.interrupted();
        }
        if (interrupted) source->forget();
        if (interpreter.ends() || console::isReadable(endsOn)) break;
    }
}

}  // namespace OCL::deploy
