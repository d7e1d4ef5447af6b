// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OCL_LUA_OPEN_LIBRARIES_HPP
#define OCL_LUA_OPEN_LIBRARIES_HPP

#include <lua.hpp>

namespace OCL::lua {

/** Gives a new state the libraries of Lua and the module `rtt`. */
void openLibraries(lua_State* lua);

}  // namespace OCL::lua

#endif
