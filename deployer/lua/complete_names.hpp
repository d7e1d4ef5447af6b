// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The names by which a value of Lua can be used.
#ifndef OCL_LUA_COMPLETE_NAMES_HPP
#define OCL_LUA_COMPLETE_NAMES_HPP

#include <lua.hpp>

#include <map>
#include <string>
#include <vector>

namespace OCL::lua {

/** Names, and whether each one is a function. */
typedef std::map<std::string, bool> Names;

/** Replaces the value on top by its field of that name; nil if there is none. Calls no Lua code. */
void takeField(lua_State* lua, const std::string& name);

/** The names of the fields, methods, operations and members of the value on top, which stays. */
Names namesOf(lua_State* lua);

/** The texts that the function `called` of the value on top, which stays, takes as an argument. */
std::vector<std::string> argumentsOf(lua_State* lua, const std::string& called);

}  // namespace OCL::lua

#endif
