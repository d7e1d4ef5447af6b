// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The common part of the programs that are an interpreter of Lua; each has a short main file of its own.
#ifndef OROFORGE_DEPLOYER_LUA_PROGRAM_HPP
#define OROFORGE_DEPLOYER_LUA_PROGRAM_HPP

#include "../lua/script.hpp"

#include <ocl/DeploymentComponent.hpp>

#include <memory>
#include <vector>

namespace OCL::deploy {

/** A component with a Lua interpreter. */
struct LuaOwner {
    std::unique_ptr<RTT::TaskContext> component;
    lua::State* state;
};

/** `Base` is LuaComponent or one derived from it; its interpreter is open to the program. */
template <class Base>
class OpenLua final : public Base {
public:
    OpenLua() : Base("lua") {}
    ~OpenLua() override { this->stopForGood(); }
    lua::State& state() { return this->script().state(); }

    static LuaOwner make() {
        auto made = std::make_unique<OpenLua>();
        lua::State* const state = &made->state();
        return {std::move(made), state};
    }
};

/** How a program differs from others. */
struct LuaProgram {
    const char* name;
    LuaOwner (*makeLua)();
    /** Makes a deployer for other processes, if "--" is in the command line: the words are the program's name and what
        follows it, which is not for Lua; a null ends them. Without this function, "--" has no such meaning. */
    std::unique_ptr<DeploymentComponent> (*makeServer)(std::vector<char*>& words) = nullptr;
    void (*end)() = nullptr;  // after the components have ended
};

/** Parses the command line, starts the runtime, does what is asked for, and takes all down. Returns the exit status. */
int runLuaProgram(int argc, char** argv, const LuaProgram& program);

}  // namespace OCL::deploy

#endif
