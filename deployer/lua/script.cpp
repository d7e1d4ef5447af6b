// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "script.hpp"

#include <rtt/ExecutionEngine.hpp>
#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/located_log.hpp>
#include <rtt/os/fosi.h>

#include <algorithm>
#include <sstream>

namespace OCL::lua {

Script::Script(RTT::TaskContext& owner, std::unique_ptr<Memory> memory)
    : state_(std::make_shared<State>(owner, std::move(memory))), gate_(owner.engine()->gate()) {}

Script::~Script() = default;

namespace {

/** The length of "file:12: " at the start of a message of Lua; 0 if it has no place. */
std::size_t placeIn(const std::string& message) {
    // The name of code that is no file is its text, in which anything may stand.
    const std::size_t from = message.compare(0, 9, "[string \"") == 0 ? message.rfind("\"]:") : 0;
    for (std::size_t colon = message.find(':', from); colon != std::string::npos;
         colon = message.find(':', colon + 1)) {
        const std::size_t end = message.find_first_not_of("0123456789", colon + 1);
        if (end != std::string::npos && end > colon + 1 && message.compare(end, 2, ": ") == 0) return end + 2;
    }
    return 0;
}

/** While one exists, the component is not destroyed by another thread. */
class Present {
public:
    explicit Present(const RTT::internal::EngineGate& gate) : visit_(gate) {
        if (!visit_.engine()) throw Failure("the component of this Lua code was destroyed");
    }

private:
    const RTT::internal::EngineGate::Visit visit_;
};

}  // namespace

/** Lua puts the place in front, so that editors find it. */
void Script::report(const std::string& error) const {
    const std::string who = "component '" + state_->owner().getName() + "'";
    if (const std::size_t place = placeIn(error))
        RTT::internal::logLocated(RTT::Error, error.substr(0, place) + who + ": " + error.substr(place));
    else
        RTT::log(RTT::Error) << who << ": " << error << RTT::endlog();
}

std::string Script::check(const std::string& file) {
    const Present here(*gate_);
    return state_->check(file);
}

bool Script::file(const std::string& file) {
    const Present here(*gate_);
    std::string error;
    if (state_->runFile(file, error)) return true;
    report(error);
    return false;
}

bool Script::text(const std::string& text) {
    const Present here(*gate_);
    std::string error;
    if (state_->runText(text, text, error)) return true;
    report(error);
    return false;
}

Script::Answer Script::hook(const char* function, bool answers, double limit) {
    state_->limit.store(limit, std::memory_order_relaxed);
    Answer answer = Answer::Missing;
    std::string error;
    const auto call = [&](lua_State* lua) {
        // Without metamethods: a table that refuses unknown names would fail for each missing hook.
        lua_pushstring(lua, function);
        lua_rawget(lua, LUA_GLOBALSINDEX);
        if (lua_isnil(lua, -1)) return;
        const State::Limit limited(*state_, limit);
        lua_call(lua, 0, answers ? 1 : 0);
        answer = Answer::Yes;
        if (!answers) return;
        if (!lua_isboolean(lua, -1))
            throw Failure(std::string(function) + " has to return a bool, and returned a " + luaL_typename(lua, -1));
        if (!lua_toboolean(lua, -1)) answer = Answer::No;
    };
    if (state_->protect(error, call)) return answer;
    report(error);
    return Answer::Failed;
}

void Script::collect(double budget) {
    if (!(budget > 0) && !stepped_) return;
    std::string error;
    if (!state_->protect(error, [&](lua_State* lua) { step(lua, budget); })) report(error);
}

void Script::step(lua_State* lua, double budget) {
    if (!(budget > 0)) {
        stepped_ = false;
        (void)lua_gc(lua, LUA_GCRESTART, 0);
        return;
    }
    stepped_ = true;
    const std::int64_t start = rtos_get_time_ns();
    constexpr double kLongest = 1000;
    const std::int64_t end = start + static_cast<std::int64_t>(std::min(budget, kLongest) * 1e9);
    std::int64_t now = start;
    // Small steps, so that the last one does not go far beyond the budget.
    do {
        ++steps_;
        const bool done = lua_gc(lua, LUA_GCSTEP, 0) != 0;
        now = rtos_get_time_ns();
        if (!done) continue;
        ++cycles_;
        break;
    } while (now < end);
    // A step has set when Lua itself goes on.
    (void)lua_gc(lua, LUA_GCSTOP, 0);
    const double took = static_cast<double>(now - start) * 1e-9;
    longest_ = std::max(longest_, took);
    total_ += took;
}

std::string Script::statistics() {
    std::ostringstream text;
    const State::Entry entry(*state_);
    text << state_->bytes() << " bytes in use, " << cycles_ << " collections in " << steps_ << " steps, longest pause "
         << longest_ * 1e6 << " us, all pauses " << total_ << " s";
    return text.str();
}

}  // namespace OCL::lua
