// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "describe_operation.hpp"

#include "failure.hpp"
#include "values.hpp"

namespace OCL::lua {

void pushOperationInfo(lua_State* lua, const RTT::internal::OperationSignature& signature,
                       const RTT::OperationInterfacePart& part) {
    pushText(lua, part.getName());
    pushText(lua, part.description());
    pushText(lua, part.resultType());
    lua_pushinteger(lua, static_cast<lua_Integer>(signature.arguments.size()));
    lua_newtable(lua);
    int index = 0;
    for (const RTT::ArgumentDescription& argument : part.getArgumentList()) {
        lua_newtable(lua);
        setField(lua, "name", argument.name);
        setField(lua, "type", argument.type);
        setField(lua, "desc", argument.description);
        lua_rawseti(lua, -2, ++index);
    }
}

int pushInfoOf(lua_State* lua, RTT::OperationInterface& operations, const std::string& name) {
    const RTT::OperationInterfacePart* const part = operations.getPart(name);
    if (!part) throw Failure("there is no operation '" + name + "'");
    pushOperationInfo(lua, part->signature(), *part);
    lua_remove(lua, -5);
    return 4;
}

}  // namespace OCL::lua
