// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OCL_LUA_LUA_SERVICE_HPP
#define OCL_LUA_LUA_SERVICE_HPP

#include "script.hpp"

#include <rtt/Service.hpp>

#include <memory>
#include <stdexcept>
#include <string>

namespace OCL {

/** Gives any component an interpreter of its own. The operations execute in the thread of the caller. */
class LuaService : public RTT::Service {
    /** Throws if there is none: without a component there is no thread, and nothing to script. */
    static RTT::TaskContext& componentOf(RTT::TaskContext* owner) {
        if (!owner) throw std::runtime_error("the service Lua belongs to a component; it is no global service");
        return *owner;
    }

public:
    explicit LuaService(RTT::TaskContext* owner) : LuaService("Lua", owner, std::make_unique<lua::SystemMemory>()) {}
    LuaService(const std::string& name, RTT::TaskContext* owner, std::unique_ptr<lua::Memory> memory)
        : RTT::Service(name, owner), script_(componentOf(owner), std::move(memory)) {
        doc("An interpreter of Lua for this component.");
        addOperation("exec_file", &lua::Script::file, &script_)
            .doc("Executes a file of Lua code. False if that fails.")
            .arg("filename", "The file");
        addOperation("exec_str", &lua::Script::text, &script_)
            .doc("Executes Lua code. False if that fails.")
            .arg("lua-string", "The code");
        addOperation("check_file", &lua::Script::check, &script_)
            .doc("Only compiles a file of Lua code. Empty if that is possible, otherwise the error with its place.")
            .arg("filename", "The file");
    }

protected:
    lua::Script script_;
};

}  // namespace OCL

#endif
