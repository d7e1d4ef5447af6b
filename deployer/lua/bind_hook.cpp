// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A Lua function as a function of the component's engine.
#include "bindings.hpp"
#include "box.hpp"
#include "engine_hook.hpp"
#include "state.hpp"
#include "values.hpp"

#include <rtt/ExecutionEngine.hpp>
#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/engine/hook_in_progress.hpp>

namespace OCL::lua {

EngineHook::EngineHook(State& state, std::string function) : state_(state), function_(std::move(function)) {}

EngineHook::~EngineHook() { disable(); }

bool EngineHook::enable() {
    const std::lock_guard<std::mutex> one(enabling_);
    return isLoaded() || state_.caller()->runFunction(this);
}
bool EngineHook::disable() {
    // Also while the component is being destroyed: the engine tells its functions before it ends.
    RTT::ExecutionEngine* const engine = getEngine();
    return !engine || engine->removeFunction(this);
}

bool EngineHook::execute() {
    const RTT::internal::HookInProgress here(&state_.owner(), "a Lua function of the engine");
    bool goesOn = false;
    std::string why;
    const auto call = [&](lua_State* lua) {
        lua_pushstring(lua, function_.c_str());
        lua_rawget(lua, LUA_GLOBALSINDEX);
        if (!lua_isfunction(lua, -1)) throw Failure("there is no such function");
        const State::Limit limited(state_, state_.limit.load(std::memory_order_relaxed));
        lua_call(lua, 0, 1);
        if (!lua_isboolean(lua, -1))
            throw Failure(std::string("it has to return a bool, not a ") + luaL_typename(lua, -1));
        goesOn = lua_toboolean(lua, -1) != 0;
    };
    if (state_.protect(why, call)) return goesOn;
    RTT::log(RTT::Error) << "component '" << state_.owner().getName() << "': the engine no longer calls Lua function '"
                         << function_ << "': " << why << RTT::endlog();
    return false;
}

namespace {

struct HookBox {
    static constexpr const char* kName = "EEHook";
    std::shared_ptr<EngineHook> hook;
};

int make(lua_State* lua) {
    State& state = State::of(lua);
    const auto made = std::make_shared<EngineHook>(state, textAt(lua, 1));
    state.keep(made);
    pushBox<HookBox>(lua, made);
    return 1;
}

template <bool (EngineHook::*Change)()>
int change(lua_State* lua) {
    const std::shared_ptr<EngineHook> hook = boxAt<HookBox>(lua, 1).hook;
    bool done;
    {
        const State::Leave leave(State::of(lua));
        done = (*hook.*Change)();
    }
    lua_pushboolean(lua, done);
    return 1;
}

}  // namespace

void bindHook(lua_State* lua) {
    const luaL_Reg methods[] = {{"new", &guarded<&make>},
                                {"enable", &guarded<&change<&EngineHook::enable>>},
                                {"disable", &guarded<&change<&EngineHook::disable>>},
                                {nullptr, nullptr}};
    const luaL_Reg events[] = {{nullptr, nullptr}};
    registerKind<HookBox>(lua, methods, events);
}

}  // namespace OCL::lua
