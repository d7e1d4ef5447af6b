// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Errors between C++ and Lua. The Lua library is the one that is compiled as C++: its errors are C++ exceptions of
// its own, so that destructors run; they are no std::exception.
#ifndef OCL_LUA_FAILURE_HPP
#define OCL_LUA_FAILURE_HPP

#include <lua.hpp>

#include <stdexcept>
#include <string>

namespace OCL::lua {

/** Becomes an error of the Lua code that called, with its file and line in front. */
class Failure : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
    ~Failure() override;
};

/** Raises the exception that is being handled as an error of Lua. Call it within a catch block. */
[[noreturn]] void raiseCaught(lua_State* lua);

/** `Function` as Lua calls it: what it throws becomes an error of Lua. */
template <int (*Function)(lua_State*)>
int guarded(lua_State* lua) {
    try {
        return Function(lua);
    } catch (const std::exception&) {
        raiseCaught(lua);
    }
}

}  // namespace OCL::lua

#endif
