// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "pool_functions.hpp"

#include "state.hpp"

namespace OCL::lua {

namespace {

PoolMemory& pool(lua_State* lua) { return static_cast<PoolMemory&>(State::of(lua).memory()); }

int stats(lua_State* lua) {
    const PoolMemory::Usage now = pool(lua).usage();
    lua_newtable(lua);
    lua_pushnumber(lua, static_cast<lua_Number>(now.total));
    lua_setfield(lua, -2, "total");
    lua_pushnumber(lua, static_cast<lua_Number>(now.used));
    lua_setfield(lua, -2, "used");
    lua_pushnumber(lua, static_cast<lua_Number>(now.most));
    lua_setfield(lua, -2, "max");
    return 1;
}

int warn(lua_State* lua) {
    const lua_Number part = luaL_checknumber(lua, 1);
    if (!(part >= 0 && part <= 1)) throw Failure("tlsf.warn() takes a part of the pool, from 0 to 1");
    pool(lua).warnAt = part;
    return 0;
}

int trace(lua_State* lua) {
    pool(lua).traced = lua_isnone(lua, 1) || lua_toboolean(lua, 1);
    return 0;
}

const luaL_Reg kFunctions[] = {
    {"stats", &guarded<&stats>}, {"warn", &guarded<&warn>}, {"trace", &guarded<&trace>}, {nullptr, nullptr}};

}  // namespace

void addPoolFunctions(State& state) {
    std::string error;
    if (!state.protect(error, [](lua_State* lua) { luaL_register(lua, "tlsf", kFunctions); })) throw Failure(error);
}

}  // namespace OCL::lua
