// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// C++ objects as userdata of Lua.
#ifndef OCL_LUA_BOX_HPP
#define OCL_LUA_BOX_HPP

#include "failure.hpp"
#include "life.hpp"

#include <new>
#include <utility>

namespace OCL::lua {

/** The name of a kind of userdata; each kind has `static constexpr const char* kName`. Its address finds the
    metatable. */
template <class T>
struct Kind {
    static constexpr const char* name() { return T::kName; }
    static void* key() {
        static char place;
        return &place;
    }
    /** Of the metatable with which every use is an error. */
    static void* deletedKey() {
        static char place;
        return &place;
    }
};

namespace detail {
/** Pushes the metatable that was made with that key. */
inline void pushMetatable(lua_State* lua, void* key) {
    lua_pushlightuserdata(lua, key);
    lua_rawget(lua, LUA_REGISTRYINDEX);
}
[[noreturn]] void wrongKind(lua_State* lua, int index, const char* wanted);
/** Makes the metatable with which every use is an error. */
void makeDeletedMetatable(lua_State* lua, void* key, const char* name);
/** Makes the metatable of a kind and leaves the table of its methods on the stack; `methods` ends with nulls. */
void makeMetatable(lua_State* lua, void* key, const char* name, const luaL_Reg* methods, const luaL_Reg* events,
                   lua_CFunction destroy);
}  // namespace detail

/** Pushes a new userdata with a T made from these arguments. */
template <class T, class... Arguments>
T& pushBox(lua_State* lua, Arguments&&... arguments) {
    void* const place = lua_newuserdata(lua, sizeof(T));
    T* const made = ::new (place) T{std::forward<Arguments>(arguments)...};
    detail::pushMetatable(lua, Kind<T>::key());
    lua_setmetatable(lua, -2);
    return *made;
}

/** Null if there is something else. */
template <class T>
T* findBox(lua_State* lua, int index) {
    // The module `debug` can give its metatable to anything.
    if (lua_type(lua, index) != LUA_TUSERDATA || lua_objlen(lua, index) != sizeof(T)) return nullptr;
    void* const place = lua_touserdata(lua, index);
    if (!lua_getmetatable(lua, index)) return nullptr;
    detail::pushMetatable(lua, Kind<T>::key());
    const bool same = lua_rawequal(lua, -1, -2) != 0;
    lua_pop(lua, 2);
    return same ? static_cast<T*>(place) : nullptr;
}

/** Throws Failure if there is something else. */
template <class T>
T& boxAt(lua_State* lua, int index) {
    T* const found = findBox<T>(lua, index);
    if (!found) detail::wrongKind(lua, index, Kind<T>::name());
    return *found;
}

/** Destroys the object; using it is an error from now on. */
template <class T>
void destroyBox(lua_State* lua, int index) {
    T& box = boxAt<T>(lua, index);
    // Allocates nothing, because it is called when memory is used up, too.
    if (index < 0) index = lua_gettop(lua) + index + 1;
    detail::pushMetatable(lua, Kind<T>::deletedKey());
    lua_setmetatable(lua, index);
    box.~T();
}

/** `Function`, for a T that belongs to a component: no other thread destroys that meanwhile. */
template <class T, int (*Function)(lua_State*)>
int inUse(lua_State* lua) {
    const T* const box = findBox<T>(lua, 1);
    if (!box) return Function(lua);
    const Life::Use use(box->life, Kind<T>::name());
    return Function(lua);
}

/** The event __gc. */
template <class T>
int collectBox(lua_State* lua) {
    if (findBox<T>(lua, 1)) destroyBox<T>(lua, 1);
    return 0;
}

/** Registers a kind: its methods, found by name, and its events such as "__tostring". Leaves the table of the methods
    on the stack. */
template <class T>
void registerKind(lua_State* lua, const luaL_Reg* methods, const luaL_Reg* events) {
    detail::makeDeletedMetatable(lua, Kind<T>::deletedKey(), Kind<T>::name());
    detail::makeMetatable(lua, Kind<T>::key(), Kind<T>::name(), methods, events, &guarded<&collectBox<T>>);
}

}  // namespace OCL::lua

#endif
