// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_LUA_COMPONENT_HPP
#define ORO_OCL_LUA_COMPONENT_HPP

#include <ocl/OCL.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/rtt-config.h>

#include <memory>
#include <string>

namespace OCL {

namespace lua {
class Memory;
class Script;
}  // namespace lua

/**
 * A component whose hooks are global functions of Lua: configureHook, activateHook, startHook, updateHook, stopHook,
 * cleanupHook, errorHook and exceptionHook. Those that do not exist do nothing. The first three have to return a bool.
 *
 * configureHook() executes the property `lua_string`, then the file `lua_file`, then the function of that name; it
 * fails if one of them does. An error in updateHook() or errorHook() puts the component into Exception; errors in
 * the other hooks are logged with file and line.
 *
 * Threads: the interpreter serves one thread at a time; see docs/lua.md. Real time: Lua allocates memory as it runs.
 * LuaTLSFComponent takes it from a pool.
 */
class OCL_API LuaComponent : public RTT::TaskContext {
public:
    explicit LuaComponent(std::string name);
    ~LuaComponent() override;

    /** Executes a file. False, with an error logged, if that fails. Any thread; blocks while another one uses the
        interpreter. */
    bool exec_file(const std::string& file);
    /** The same for a text. */
    bool exec_str(const std::string& text);

    /** Calls activateHook first; false if that returns false. */
    bool activate() override;

protected:
    /** With memory from `memory`. Throws std::bad_alloc if that is too small. */
    LuaComponent(const std::string& name, std::unique_ptr<lua::Memory> memory);

    bool configureHook() override;
    bool startHook() override;
    void updateHook() override;
    void stopHook() override;
    void cleanupHook() override;
    void errorHook() override;
    void exceptionHook() override;

    /** The interpreter and what the component adds to it. */
    lua::Script& script() { return *script_; }

private:
    std::string lua_string_, lua_file_;
    double lua_timeout_ = 10;
    double lua_gc_budget_ = 0;
    std::unique_ptr<lua::Script> script_;
};

}  // namespace OCL

#endif
