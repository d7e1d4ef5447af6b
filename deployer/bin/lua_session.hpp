// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYER_LUA_SESSION_HPP
#define OROFORGE_DEPLOYER_LUA_SESSION_HPP

#include "../lua/state.hpp"
#include "lua_command_line.hpp"

#include <string>

namespace OCL::deploy {

/** Does what the command line says, in the calling thread. Ends when `endsOn` becomes readable. Returns the exit
    status. */
int runLuaSession(const LuaCommandLine& line, const std::string& program, lua::State& state, int endsOn);

}  // namespace OCL::deploy

#endif
