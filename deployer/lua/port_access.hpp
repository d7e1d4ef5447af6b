// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OCL_LUA_PORT_ACCESS_HPP
#define OCL_LUA_PORT_ACCESS_HPP

#include <lua.hpp>

namespace RTT::base {
class PortInterface;
}

namespace OCL::lua {

/** The port at `index`, which exists. Throws Failure. */
RTT::base::PortInterface& portAt(lua_State* lua, int index);

}  // namespace OCL::lua

#endif
