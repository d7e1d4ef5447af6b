// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// rttlua-corba-<target>: an interpreter of Lua with a deployer. If there is "--", other processes can use the deployer,
// and what follows is for the ORB.
#include "corba_program.hpp"
#include "lua_program.hpp"

#include <ocl/LuaComponent.hpp>

namespace {

using namespace OCL::deploy;

std::unique_ptr<OCL::DeploymentComponent> makeServer(std::vector<char*>& words) {
    return makeCorbaDeployer(Options(), words);
}

}  // namespace

int main(int argc, char** argv) {
    return runLuaProgram(argc, argv, {"rttlua-corba", &OpenLua<OCL::LuaComponent>::make, &makeServer, &endCorba});
}
