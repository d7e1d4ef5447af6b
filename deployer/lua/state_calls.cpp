// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// How C++ calls Lua code: never without catching its errors, because those end the process.
#include "state.hpp"

#include "bindings.hpp"
#include "open_libraries.hpp"
#include "search_paths.hpp"

#include <rtt/internal/engine/interruption.hpp>
#include <rtt/internal/engine/script_place.hpp>

#include <cstdio>

namespace OCL::lua {

namespace {

char collectorKey, bouncerKey, tracebackKey;

/** A function of C and its argument. */
struct Bounce {
    lua_CFunction function;
    void* data;
};

/** As lua_cpcall() does it, but without making a function, which allocates. */
int bounce(lua_State* lua) {
    const Bounce* const to = static_cast<const Bounce*>(lua_touserdata(lua, 1));
    lua_settop(lua, 0);
    lua_pushlightuserdata(lua, to->data);
    return to->function(lua);
}

int collectGarbage(lua_State* lua) {
    (void)lua_gc(lua, LUA_GCCOLLECT, 0);
    return 0;
}

int addTraceback(lua_State* lua) {
    if (!lua_isstring(lua, 1)) return 1;
    lua_getglobal(lua, "debug");
    if (!lua_istable(lua, -1)) {
        lua_pop(lua, 1);
        return 1;
    }
    lua_getfield(lua, -1, "traceback");
    if (!lua_isfunction(lua, -1)) {
        lua_pop(lua, 2);
        return 1;
    }
    lua_pushvalue(lua, 1);
    lua_pushinteger(lua, 2);
    lua_call(lua, 2, 1);
    return 1;
}

/** Makes functions now that are needed when there is no memory to make them. */
void keepFunction(lua_State* lua, char* key, lua_CFunction function) {
    lua_pushlightuserdata(lua, key);
    lua_pushcfunction(lua, function);
    lua_rawset(lua, LUA_REGISTRYINDEX);
}

/** "file:line" of the innermost Lua code. Allocates nothing. */
void describePlace(void* interpreter, char* text, std::size_t size) {
    auto* const lua = static_cast<lua_State*>(interpreter);
    lua_Debug where;
    for (int level = 0; lua_getstack(lua, level, &where) == 1; ++level) {
        if (lua_getinfo(lua, "Sl", &where) == 0 || where.currentline <= 0) continue;
        const char* const file = where.source[0] == '@' ? where.source + 1 : where.short_src;
        std::snprintf(text, size, "%s:%d", file, where.currentline);
        return;
    }
}

}  // namespace

void openLibraries(lua_State* lua) {
    luaL_openlibs(lua);
    keepFunction(lua, &collectorKey, &collectGarbage);
    keepFunction(lua, &bouncerKey, &bounce);
    keepFunction(lua, &tracebackKey, &addTraceback);
    openModule(lua);
    setSearchPaths(lua);
}

/** The error on the stack, which need not be a text. Raises no error itself. */
std::string takeMessage(lua_State* lua) {
    std::string message;
    if (lua_type(lua, -1) == LUA_TSTRING)
        message = lua_tostring(lua, -1);
    else
        message = std::string("(error object is a ") + luaL_typename(lua, -1) + " value)";
    lua_pop(lua, 1);
    return message;
}

bool State::call(lua_State* lua, int arguments, int results, bool traced) {
    int handler = 0;
    if (traced) {
        handler = lua_gettop(lua) - arguments;
        lua_pushlightuserdata(lua, &tracebackKey);
        lua_rawget(lua, LUA_REGISTRYINDEX);
        lua_insert(lua, handler);
    }
    int status;
    {
        using RTT::internal::Interruption;
        const Interruption::Region script(Interruption::ofThisThread(), Interruption::Region::Script);
        const RTT::internal::ScriptPlace place(&describePlace, lua);
        status = lua_pcall(lua, arguments, results, handler);
    }
    if (handler) lua_remove(lua, handler);
    if (status == LUA_ERRMEM) collectAll(lua);
    return status == 0;
}

bool State::protectCall(lua_CFunction function, void* data, std::string& error) {
    try {
        const Entry entry(*this);
        return protectCall(entry.lua(), function, data, error);
    } catch (const Failure& why) {
        error = why.what();
    } catch (const std::bad_alloc&) {
        error = "not enough memory";
    }
    return false;
}

bool State::protectCall(lua_State* lua, lua_CFunction function, void* data, std::string& error) {
    using RTT::internal::Interruption;
    const Interruption::Region script(Interruption::ofThisThread(), Interruption::Region::Script);
    const RTT::internal::ScriptPlace place(&describePlace, lua);
    int status;
    const int before = lua_gettop(lua);
    lua_pushlightuserdata(lua, &bouncerKey);
    lua_rawget(lua, LUA_REGISTRYINDEX);
    if (lua_isnil(lua, -1)) {
        lua_pop(lua, 1);
        status = lua_cpcall(lua, function, data);
    } else {
        Bounce to{function, data};
        lua_pushlightuserdata(lua, &to);
        status = lua_pcall(lua, 1, 0, 0);
    }
    if (status == 0) return true;
    error = status < 0 ? "C++ code threw something that is no std::exception" : takeMessage(lua);
    lua_settop(lua, before);
    if (status == LUA_ERRMEM) collectAll(lua);
    return false;
}

/** Lua itself does not try this when memory is used up. */
void State::collectAll(lua_State* lua) {
    lua_pushlightuserdata(lua, &collectorKey);
    lua_rawget(lua, LUA_REGISTRYINDEX);
    if (lua_pcall(lua, 0, 0, 0) != 0) lua_pop(lua, 1);
}

bool State::runFile(const std::string& file, std::string& error) {
    return protect(error, [&](lua_State* lua) {
        if (luaL_loadfile(lua, file.c_str()) != 0) lua_error(lua);
        lua_call(lua, 0, 0);
    });
}

std::string State::check(const std::string& file) {
    std::string error;
    (void)protect(error, [&](lua_State* lua) {
        if (luaL_loadfile(lua, file.c_str()) != 0) lua_error(lua);
    });
    return error;
}

bool State::runText(const std::string& text, const std::string& name, std::string& error) {
    return protect(error, [&](lua_State* lua) {
        if (luaL_loadbuffer(lua, text.data(), text.size(), name.c_str()) != 0) lua_error(lua);
        lua_call(lua, 0, 0);
    });
}

}  // namespace OCL::lua
