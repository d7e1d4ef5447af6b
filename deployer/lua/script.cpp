// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "script.hpp"

#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/located_log.hpp>
#include <rtt/os/fosi.h>

#include <algorithm>
#include <sstream>

namespace OCL::lua {

Script::Script(RTT::TaskContext& owner, std::unique_ptr<Memory> memory)
    : state_(std::make_shared<State>(owner, std::move(memory))) {}

Script::~Script() = default;

/** Lua puts the place in front, so that editors find it. */
void Script::report(const std::string& error) const {
    const std::string who = "component '" + state_->owner().getName() + "'";
    const auto colon = error.find(": ");
    const bool located =
        colon != std::string::npos && colon != 0 && std::isdigit(static_cast<unsigned char>(error[colon - 1]));
    if (located)
        RTT::internal::logLocated(RTT::Error, error.substr(0, colon + 2) + who + ": " + error.substr(colon + 2));
    else
        RTT::log(RTT::Error) << who << ": " << error << RTT::endlog();
}

bool Script::file(const std::string& file) {
    std::string error;
    if (state_->runFile(file, error)) return true;
    report(error);
    return false;
}

bool Script::text(const std::string& text) {
    std::string error;
    if (state_->runText(text, text, error)) return true;
    report(error);
    return false;
}

Script::Answer Script::hook(const char* function, bool answers, double limit) {
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
    const std::int64_t end = start + static_cast<std::int64_t>(budget * 1e9);
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
