// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// rttlua-corba-<target>: an interpreter of Lua with a deployer that other processes can use. What follows "--" is for
// the ORB.
#include "corba_program.hpp"
#include "lua_program.hpp"

#include <ocl/LuaComponent.hpp>
#include <rtt/Logger.hpp>

namespace {

using namespace OCL::deploy;

std::unique_ptr<OCL::DeploymentComponent> make(std::vector<char*>& words) {
    if (auto made = makeCorbaDeployer(Options(), words)) return made;
    RTT::log(RTT::Warning) << "other processes cannot use the deployer: there is no ORB" << RTT::endlog();
    return makePlainDeployer(words);
}

}  // namespace

int main(int argc, char** argv) {
    return runLuaProgram(
        argc, argv, {"rttlua-corba", &OpenLua<OCL::LuaComponent>::make, &make, /*wordsForRuntime=*/true, &endCorba});
}
