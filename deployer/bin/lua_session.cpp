// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "lua_session.hpp"

#include "../console/interrupts.hpp"
#include "../console/line_source.hpp"
#include "../console/wanted.hpp"
#include "../lua/interpreter.hpp"
#include "lua_prompt.hpp"

#include <rtt/rtt-config.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

#include <unistd.h>

namespace OCL::deploy {
namespace {

using lua::Interpreter;

class Session {
public:
    Session(const LuaCommandLine& line, const std::string& program, lua::State& state, int endsOn)
        : line_(line),
          endsOn_(endsOn),
          hasInput_(console::isWanted()),
          isTyped_(hasInput_ && isatty(STDIN_FILENO)),
          interpreter_(state, program),
          interrupts_(endsOn, /*onTerminal=*/true) {}

    int run() {
        bool good = false;
        const bool ran = interpreter_.run([this, &good] {
            good = start() && doSteps() && doScript();
            if (!good || !(line_.interactive || startsTyping()) || isOver()) return;
            interpreter_.setProgram("");
            if (!hasInput_) return waitForEnd();
            promptForLua(interpreter_, interrupts_, endsOn_);
        });
        if (interpreter_.ends()) return interpreter_.status();
        return ran && good ? EXIT_SUCCESS : EXIT_FAILURE;
    }

private:
    /** In place of a prompt. */
    void waitForEnd() {
        const lua::State::Leave leave(interpreter_.state());
        while (console::waitForInput(-1, endsOn_) == console::Wake::Signal) {
        }
    }

    bool startsTyping() const { return line_.isEmpty() && isTyped_; }
    bool isOver() const { return interpreter_.ends() || console::isReadable(endsOn_); }

    /** One step, which Ctrl-C can end. */
    template <class Step>
    bool execute(Step step) {
        if (isOver()) return false;
        const console::Interrupts::Command command(interrupts_);
        return step();
    }

    bool start() {
        readUsersFile();
        if (!execute([this] { return interpreter_.initialise(); })) return false;
        if (line_.version || startsTyping()) showVersions();
        return true;
    }

    /** An error in it is reported, and ends nothing. */
    void readUsersFile() {
        const char* const home = std::getenv("HOME");
        if (!home) return;
        const std::string file = std::string(home) + "/.rttlua";
        std::error_code unknown;
        const auto found = std::filesystem::status(file, unknown);
        if (!std::filesystem::exists(found)) return;
        if (std::filesystem::is_regular_file(found))
            (void)execute([&] { return interpreter_.file(file); });
        else
            interpreter_.complain(file + ": is not executed, because it is no regular file");
    }

    void showVersions() const {
        std::fflush(stdout);
        std::fputs("Oroforge " ORO_STRINGIFY(RTT_VERSION) ", " LUA_RELEASE ", target " OROCOS_TARGET_NAME "\n", stderr);
        if (isTyped_ && (line_.interactive || line_.isEmpty()))
            std::fputs("TAB completes, Ctrl-R searches what was typed before, Ctrl-C interrupts, Ctrl-D leaves.\n",
                       stderr);
    }

    bool doSteps() {
        for (const LuaCommandLine::Step& step : line_.steps) {
            const bool good = execute([&] {
                return step.kind == LuaCommandLine::Step::Execute ? interpreter_.text(step.text, "=(command line)")
                                                                  : interpreter_.require(step.text);
            });
            if (!good) return false;
        }
        return true;
    }

    bool doScript() {
        const Interpreter::Words words{line_.words, line_.script};
        if (line_.script && !line_.scriptIsInput()) return execute([&] { return interpreter_.script(words); });
        if (!line_.script && (!line_.isEmpty() || line_.interactive || isTyped_)) return true;
        std::string code;
        if (!readInput(code)) return false;
        return execute([&] {
            return line_.script ? interpreter_.script(words, std::move(code)) : interpreter_.input(std::move(code));
        });
    }

    /** Reads standard input to its end. */
    bool readInput(std::string& code) {
        if (!hasInput_) return true;
        const lua::State::Leave leave(interpreter_.state());
        for (;;) {
            const console::Wake woken = console::waitForInput(STDIN_FILENO, endsOn_);
            if (woken == console::Wake::Signal) continue;
            if (woken == console::Wake::End) return false;
            char block[4096];
            const ssize_t got = ::read(STDIN_FILENO, block, sizeof block);
            if (got == 0) return true;
            if (got > 0) {
                code.append(block, static_cast<std::size_t>(got));
            } else if (errno != EINTR) {
                interpreter_.complain(std::string("cannot read stdin: ") + std::strerror(errno));
                return false;
            }
        }
    }

    const LuaCommandLine& line_;
    const int endsOn_;
    const bool hasInput_;
    const bool isTyped_;
    Interpreter interpreter_;
    console::Interrupts interrupts_;
};

}  // namespace

int runLuaSession(const LuaCommandLine& line, const std::string& program, lua::State& state, int endsOn) {
    Session session(line, program, state, endsOn);
    return session.run();
}

}  // namespace OCL::deploy
