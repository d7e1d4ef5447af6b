// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OCL_LUA_DESCRIBE_OPERATION_HPP
#define OCL_LUA_DESCRIBE_OPERATION_HPP

#include <rtt/OperationInterface.hpp>
#include <rtt/internal/calls/operation_signature.hpp>

#include <lua.hpp>

namespace OCL::lua {

/** Pushes name, description, type of the result, number of arguments, and a table of {name, type, desc} for each. */
void pushOperationInfo(lua_State* lua, const RTT::internal::OperationSignature& signature,
                       const RTT::OperationInterfacePart& part);
/** The same without the name: what getOpInfo() and getOperationInfo() give. Throws Failure if there is no such
    operation. */
int pushInfoOf(lua_State* lua, RTT::OperationInterface& operations, const std::string& name);

}  // namespace OCL::lua

#endif
