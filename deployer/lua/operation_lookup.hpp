// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OCL_LUA_OPERATION_LOOKUP_HPP
#define OCL_LUA_OPERATION_LOOKUP_HPP

#include <rtt/Service.hpp>

#include <lua.hpp>

namespace OCL::lua {

/**
 * For the event __index of a component or service at index 1, with its methods as upvalue: pushes what the name at
 * index 2 stands for. With rttlib loaded, operations of that name come first, otherwise methods; nil if there is
 * neither. The operation takes the component or service as first argument, as in `component:operation(1)`.
 */
int findMethod(lua_State* lua, const RTT::Service::shared_ptr& service);

/** What rttlib calls: operations hide methods of the same name from now on. */
int operationsFirst(lua_State* lua);

}  // namespace OCL::lua

#endif
