// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OCL_LUA_PROVIDED_OPERATION_HPP
#define OCL_LUA_PROVIDED_OPERATION_HPP

#include <rtt/Service.hpp>

#include <lua.hpp>

namespace OCL::lua {

/** Adds an operation that a Lua function executes: index 2 is its name, 3 its signature as in C++, 4 the function, 5
    may be its description. Throws Failure. */
void provideOperation(lua_State* lua, RTT::Service& service);
/** True if a Lua function of this state executes it. */
bool isProvidedHere(lua_State* lua, const RTT::OperationInterfacePart* part);

}  // namespace OCL::lua

#endif
