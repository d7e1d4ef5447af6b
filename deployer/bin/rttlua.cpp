// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// rttlua-<target>: an interpreter of Lua with a deployer.
#include "lua_program.hpp"

#include <ocl/LuaComponent.hpp>

int main(int argc, char** argv) {
    using namespace OCL::deploy;
    return runLuaProgram(argc, argv, {"rttlua", &OpenLua<OCL::LuaComponent>::make});
}
