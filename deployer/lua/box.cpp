// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "box.hpp"

#include <string>

namespace OCL::lua::detail {

namespace {

/** The name of the kind of a userdata, or of the type of any other value. */
std::string nameOf(lua_State* lua, int index) {
    std::string name = luaL_typename(lua, index);
    if (index > lua_gettop(lua)) return "nothing";
    if (luaL_getmetafield(lua, index, "__name")) {
        if (lua_isstring(lua, -1)) name = lua_tostring(lua, -1);
        lua_pop(lua, 1);
    }
    return name;
}

int useDeleted(lua_State* lua) {
    return luaL_error(lua, "this %s was deleted", lua_tostring(lua, lua_upvalueindex(1)));
}

int describeDeleted(lua_State* lua) {
    lua_pushfstring(lua, "deleted %s", lua_tostring(lua, lua_upvalueindex(1)));
    return 1;
}

}  // namespace

void wrongKind(lua_State* lua, int index, const char* wanted) {
    throw Failure(std::string("this takes a ") + wanted + " as argument " + std::to_string(index) + ", not " +
                  nameOf(lua, index));
}

void makeDeletedMetatable(lua_State* lua, void* key, const char* name) {
    lua_pushlightuserdata(lua, key);
    lua_newtable(lua);
    for (const char* event : {"__index", "__newindex", "__call"}) {
        lua_pushstring(lua, name);
        lua_pushcclosure(lua, &useDeleted, 1);
        lua_setfield(lua, -2, event);
    }
    lua_pushstring(lua, name);
    lua_pushcclosure(lua, &describeDeleted, 1);
    lua_setfield(lua, -2, "__tostring");
    lua_pushfstring(lua, "deleted %s", name);
    lua_setfield(lua, -2, "__name");
    lua_rawset(lua, LUA_REGISTRYINDEX);
}

void makeMetatable(lua_State* lua, void* key, const char* name, const luaL_Reg* methods, const luaL_Reg* events,
                   lua_CFunction destroy) {
    luaL_newmetatable(lua, name);
    lua_pushlightuserdata(lua, key);
    lua_pushvalue(lua, -2);
    lua_rawset(lua, LUA_REGISTRYINDEX);
    lua_pushstring(lua, name);
    lua_setfield(lua, -2, "__name");
    lua_pushcfunction(lua, destroy);
    lua_setfield(lua, -2, "__gc");
    lua_newtable(lua);
    for (const luaL_Reg* method = methods; method->name; ++method) {
        lua_pushcfunction(lua, method->func);
        lua_setfield(lua, -2, method->name);
    }
    // Without an event of its own, a userdata is indexed by its methods.
    lua_pushvalue(lua, -1);
    lua_setfield(lua, -3, "__index");
    for (const luaL_Reg* event = events; event->name; ++event) {
        lua_pushvalue(lua, -1);
        lua_pushcclosure(lua, event->func, 1);
        lua_setfield(lua, -3, event->name);
    }
    lua_remove(lua, -2);
}

}  // namespace OCL::lua::detail
