// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "failure.hpp"

#include "state.hpp"

#include <rtt/internal/engine/interruption.hpp>

namespace OCL::lua {

Failure::~Failure() = default;

void raiseCaught(lua_State* lua) {
    luaL_where(lua, 1);
    try {
        throw;
    } catch (const RTT::internal::Interrupted& interrupted) {
        // Lua code that catches it meets it again soon.
        State::of(lua).lookSoon(lua);
        lua_pushstring(lua, interrupted.what());
    } catch (const std::bad_alloc&) {
        lua_pushliteral(lua, "not enough memory");
    } catch (const std::exception& error) {
        lua_pushstring(lua, error.what());
    }
    lua_concat(lua, 2);
    lua_error(lua);
    throw;  // never reached
}

}  // namespace OCL::lua
