// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "operation_lookup.hpp"

#include "bindings.hpp"
#include "box.hpp"
#include "operation_call.hpp"
#include "state.hpp"
#include "things.hpp"

namespace OCL::lua {

namespace {

char cacheKey;

int callAsMethod(lua_State* lua) {
    // Finalizers may call it after that of the operation.
    const Operation* const operation = findBox<Operation>(lua, lua_upvalueindex(1));
    if (!operation) throw Failure("this Operation was deleted");
    const std::shared_ptr<OperationCall> call = operation->call;
    return call->call(lua, 2);
}

/** The functions made for operations of the object at index 1, by name; they are kept in its environment. */
void pushCache(lua_State* lua) {
    lua_getfenv(lua, 1);
    lua_pushlightuserdata(lua, &cacheKey);
    lua_rawget(lua, -2);
    if (lua_istable(lua, -1)) {
        lua_remove(lua, -2);
        return;
    }
    lua_pop(lua, 2);
    lua_newtable(lua);
    lua_newtable(lua);
    lua_pushlightuserdata(lua, &cacheKey);
    lua_pushvalue(lua, -2);
    lua_rawset(lua, -4);
    lua_insert(lua, -2);
    lua_setfenv(lua, 1);
}

/** Pushes the function for the operation that the name at index 2 names; nothing, and false, if there is none. */
bool pushOperationMethod(lua_State* lua, const RTT::Service::shared_ptr& service) {
    const char* const name = lua_tostring(lua, 2);
    const RTT::OperationInterfacePart* const part = service->getPart(name);
    if (!part) return false;
    pushCache(lua);
    lua_pushvalue(lua, 2);
    lua_rawget(lua, -2);
    if (lua_tocfunction(lua, -1) == &guarded<&callAsMethod> && lua_getupvalue(lua, -1, 1)) {
        const Operation* const known = findBox<Operation>(lua, -1);
        lua_pop(lua, 1);
        if (known && known->call->part().get() == part) {
            lua_remove(lua, -2);
            return true;
        }
    }
    lua_pop(lua, 1);
    pushOperation(lua, service, name);
    lua_pushcclosure(lua, &guarded<&callAsMethod>, 1);
    lua_pushvalue(lua, 2);
    lua_pushvalue(lua, -2);
    lua_rawset(lua, -4);
    lua_remove(lua, -2);
    return true;
}

bool pushMethod(lua_State* lua) {
    lua_pushvalue(lua, 2);
    lua_rawget(lua, lua_upvalueindex(1));
    if (!lua_isnil(lua, -1)) return true;
    lua_pop(lua, 1);
    return false;
}

}  // namespace

int findMethod(lua_State* lua, const RTT::Service::shared_ptr& service) {
    const bool isName = lua_type(lua, 2) == LUA_TSTRING;
    const bool operations = isName && State::of(lua).operationsFirst;
    if (operations && pushOperationMethod(lua, service)) return 1;
    if (pushMethod(lua)) return 1;
    if (isName && !operations && pushOperationMethod(lua, service)) return 1;
    lua_pushnil(lua);
    return 1;
}

int operationsFirst(lua_State* lua) {
    State::of(lua).operationsFirst = true;
    return 0;
}

}  // namespace OCL::lua
