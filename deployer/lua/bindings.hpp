// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The parts of the module `rtt`. Each function registers one kind of userdata and leaves the table of its methods on
// the stack.
#ifndef OCL_LUA_BINDINGS_HPP
#define OCL_LUA_BINDINGS_HPP

#include <rtt/Service.hpp>

#include <lua.hpp>

#include <string>

namespace RTT {
class TaskContext;
}

namespace OCL::lua {

/** The module itself, as the global `rtt` and for require("rtt"). */
void openModule(lua_State* lua);

void bindVariable(lua_State* lua);
void bindProperty(lua_State* lua);
void bindAttribute(lua_State* lua);
void bindInputPort(lua_State* lua);
void bindOutputPort(lua_State* lua);
void bindOperation(lua_State* lua);
void bindSendHandle(lua_State* lua);
void bindService(lua_State* lua);
void bindRequester(lua_State* lua);
void bindTask(lua_State* lua);
void bindHook(lua_State* lua);

/** What Lua code of this state has made, and what still exists. They throw Failure. */
RTT::base::PropertyBase& ownPropertyAt(lua_State* lua, int index);
RTT::base::AttributeBase& ownAttributeAt(lua_State* lua, int index);
RTT::base::PortInterface& ownPortAt(lua_State* lua, int index);

void pushTask(lua_State* lua, RTT::TaskContext& component);
void pushService(lua_State* lua, const RTT::Service::shared_ptr& service);
void pushOperation(lua_State* lua, const RTT::Service::shared_ptr& service, const std::string& name);
/** `nullptr` throws Failure. */
void pushPort(lua_State* lua, RTT::Service& home, const std::string& name);
void pushProperty(lua_State* lua, RTT::Service& home, RTT::base::PropertyBase* property);
void pushAttribute(lua_State* lua, RTT::Service& home, RTT::base::AttributeBase* attribute);

}  // namespace OCL::lua

#endif
