// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OCL_LUA_ENGINE_HOOK_HPP
#define OCL_LUA_ENGINE_HOOK_HPP

#include <rtt/base/ExecutableInterface.hpp>

#include <mutex>
#include <string>

namespace OCL::lua {

class State;

/** Has the engine of the component call a global Lua function in each step, until that returns false or fails. */
class EngineHook : public RTT::base::ExecutableInterface {
public:
    EngineHook(State& state, std::string function);
    ~EngineHook() override;

    bool enable();
    /** Blocks while the function is being executed by another thread. */
    bool disable();
    bool execute() override;

private:
    State& state_;
    const std::string function_;
    std::mutex enabling_;
};

}  // namespace OCL::lua

#endif
