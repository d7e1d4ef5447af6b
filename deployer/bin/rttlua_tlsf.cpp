// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// rttlua-tlsf-<target>: an interpreter of Lua with a deployer, the memory of Lua from a pool.
#include "lua_program.hpp"

#include <ocl/LuaTLSFComponent.hpp>

int main(int argc, char** argv) {
    using namespace OCL::deploy;
    return runLuaProgram(argc, argv, {"rttlua-tlsf", &OpenLua<OCL::LuaTLSFComponent>::make});
}
