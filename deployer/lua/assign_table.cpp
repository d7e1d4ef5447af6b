// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "assign_table.hpp"

#include "conversion.hpp"

#include <rtt/types/SequenceOps.hpp>

namespace OCL::lua {

using RTT::base::DataSourceBase;

namespace {

void assignPart(lua_State* lua, DataSourceBase& whole, const std::string& name) {
    const DataSourceBase::shared_ptr part = whole.getMember(name);
    if (!part || !part->isAssignable())
        throw Failure("type " + whole.getTypeName() + " has no member '" + name + "' that can be assigned");
    try {
        assign(lua, lua_gettop(lua), *part);
    } catch (const Failure& why) {
        throw Failure("member '" + name + "': " + why.what());
    }
}

bool hasRoom(DataSourceBase& target, const RTT::types::SequenceOps& elements, std::size_t size) {
    const void* const container = target.evaluate() ? target.getRawConstPointer() : nullptr;
    return container && size <= elements.size(container);
}

void assignElements(lua_State* lua, int index, DataSourceBase& target, const RTT::types::SequenceOps& elements) {
    const int size = static_cast<int>(lua_objlen(lua, index));
    // What cannot be resized, such as an array, takes what it has room for.
    if (!target.getTypeInfo()->resize(&target, size) && !hasRoom(target, elements, static_cast<std::size_t>(size)))
        throw Failure("type " + target.getTypeName() + " has no room for " + std::to_string(size) + " elements");
    for (int i = 0; i != size; ++i) {
        lua_rawgeti(lua, index, i + 1);
        assignPart(lua, target, std::to_string(i));
        lua_pop(lua, 1);
    }
}

}  // namespace

void assignTable(lua_State* lua, int index, DataSourceBase& target, const RTT::types::Shape& shape) {
    if (index < 0) index = lua_gettop(lua) + index + 1;
    luaL_checkstack(lua, 8, "the table is nested too deeply");
    if (shape.kind == RTT::types::Shape::Kind::Sequence) return assignElements(lua, index, target, *shape.elements);
    lua_pushnil(lua);
    while (lua_next(lua, index) != 0) {
        // A number as key is an index from 1; lua_tostring() on the key itself would confuse lua_next().
        std::string name;
        if (lua_type(lua, -2) == LUA_TSTRING)
            name = lua_tostring(lua, -2);
        else if (lua_type(lua, -2) == LUA_TNUMBER)
            name = std::to_string(static_cast<long>(lua_tonumber(lua, -2)) - 1);
        else
            throw Failure(std::string("a ") + luaL_typename(lua, -2) + " cannot name a member");
        assignPart(lua, target, name);
        lua_pop(lua, 1);
    }
    target.updated();
}

}  // namespace OCL::lua
