// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OCL_LUA_SEARCH_PATHS_HPP
#define OCL_LUA_SEARCH_PATHS_HPP

#include <lua.hpp>

namespace OCL::lua {

/** Lets `require` find the modules of this toolchain, after those of LUA_PATH, wherever the toolchain is installed. */
void setSearchPaths(lua_State* lua);

}  // namespace OCL::lua

#endif
