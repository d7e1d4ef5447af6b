// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OCL_LUA_SCRIPT_HPP
#define OCL_LUA_SCRIPT_HPP

#include "state.hpp"

#include <atomic>
#include <memory>
#include <string>

namespace OCL::lua {

/** The Lua code of a component, with errors in the log. */
class Script {
public:
    Script(RTT::TaskContext& owner, std::unique_ptr<Memory> memory);
    ~Script();

    State& state() { return *state_; }

    /** False, with an error logged, if that fails. */
    bool file(const std::string& file);
    bool text(const std::string& text);

    enum class Answer {
        Missing,  ///< there is no such function
        Yes,      ///< it returned true, or nothing where it need not
        No,       ///< it returned false
        Failed    ///< it failed or returned no bool; an error was logged
    };
    /** Calls a global function, for at most `limit` seconds of Lua code; 0 for no limit. */
    Answer hook(const char* function, bool answers, double limit);

    /** Collects garbage for at most so many seconds; with 0 Lua collects by itself, whenever it allocates. */
    void collect(double budget);
    /** What collect() measured. */
    std::string statistics();

    /** Compiles a file. What is wrong; empty if it can be executed. */
    std::string check(const std::string& file);

private:
    void report(const std::string& error) const;
    void step(lua_State* lua, double budget);

    const std::shared_ptr<State> state_;
    const boost::intrusive_ptr<const RTT::internal::EngineGate> gate_;
    bool stepped_ = false;  // Lua does not collect by itself
    std::uint64_t steps_ = 0, cycles_ = 0;
    double longest_ = 0, total_ = 0;
};

}  // namespace OCL::lua

#endif
