// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OCL_LUA_INTERPRETER_HPP
#define OCL_LUA_INTERPRETER_HPP

#include "state.hpp"

#include <atomic>
#include <functional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace OCL::lua {

/**
 * Does what the stand-alone interpreter of Lua does, in the thread that made it, with errors on standard error. Code
 * that was executed with success returns true. Only one may exist for a state.
 */
class Interpreter {
public:
    /** Errors begin with the name of the program; see also setProgram(). */
    Interpreter(State& state, std::string program);
    ~Interpreter();
    Interpreter(const Interpreter&) = delete;
    Interpreter& operator=(const Interpreter&) = delete;

    /** Calls `body` as a function of Lua would be called; all others are for use in it. False if it threw. */
    bool run(const std::function<void()>& body);

    /** An empty name: errors begin with their place. */
    void setProgram(std::string program) { program_ = std::move(program); }

    bool text(const std::string& code, const std::string& name);
    bool file(const std::string& file);
    bool require(const std::string& module);
    /** What the environment variable LUA_INIT says. */
    bool initialise();

    /** Words of a command line, and which of them is the script. */
    struct Words {
        const std::vector<std::string>& all;
        std::size_t script;
    };
    /** Executes a file with the words after it as arguments, and all of them in the global table `arg`. */
    bool script(const Words& words);
    /** The same for what standard input has. */
    bool script(const Words& words, std::string code);
    /** Executes what standard input has, without arguments. */
    bool input(std::string code);

    /** True if a statement that is typed is not complete. */
    bool goesOn(const std::string& statement);
    /** Executes what was typed, and prints the values that it returns. */
    void typed(const std::string& statement);
    /** What the global variable says, or the other text. */
    std::string prompt(const char* variable, const char* otherwise);

    /** True after os.exit(), in any thread: nothing more is to be executed. */
    bool ends() const { return ends_.load(); }
    /** What os.exit() was called with. */
    int status() const { return status_.load(); }
    State& state() { return state_; }
    void complain(const std::string& message) const;

private:
    static int onExit(lua_State* lua);
    bool call(int arguments, int results);
    bool loaded(int failure);
    bool scriptLoaded(const Words& words);
    void report();

    State& state_;
    std::string program_;
    const std::thread::id thread_;
    lua_State* lua_ = nullptr;  // within run()
    std::atomic<bool> ends_{false};
    std::atomic<int> status_{0};
};

}  // namespace OCL::lua

#endif
