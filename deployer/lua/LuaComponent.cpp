// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <ocl/LuaComponent.hpp>

#include "script.hpp"

#include <ocl/Component.hpp>

namespace OCL {

using lua::Script;
typedef Script::Answer Answer;

LuaComponent::LuaComponent(std::string name) : LuaComponent(name, std::make_unique<lua::SystemMemory>()) {}

LuaComponent::LuaComponent(const std::string& name, std::unique_ptr<lua::Memory> memory)
    : RTT::TaskContext(name, PreOperational), script_(new Script(*this, std::move(memory))) {
    addProperty("lua_string", lua_string_).doc("Lua code that configure() executes first.");
    addProperty("lua_file", lua_file_).doc("A file that configure() executes, after lua_string.");
    addProperty("lua_timeout", lua_timeout_)
        .doc("The longest time in seconds that a hook may run Lua code without calling C++; 0 for no limit.");
    addProperty("lua_gc_budget", lua_gc_budget_)
        .doc(
            "The longest time in seconds for garbage collection after each updateHook(); with 0 Lua collects whenever "
            "it likes.");
    addOperation("exec_file", &LuaComponent::exec_file, this, RTT::OwnThread)
        .doc("Executes a file of Lua code. False if that fails.")
        .arg("filename", "The file");
    addOperation("exec_str", &LuaComponent::exec_str, this, RTT::OwnThread)
        .doc("Executes Lua code. False if that fails.")
        .arg("lua-string", "The code");
    addOperation("lua_statistics", &Script::statistics, script_.get(), RTT::OwnThread)
        .doc("The memory that Lua uses, and what garbage collection took, as text.");
}

LuaComponent::~LuaComponent() { stopForGood(); }

bool LuaComponent::exec_file(const std::string& file) { return script_->file(file); }
bool LuaComponent::exec_str(const std::string& text) { return script_->text(text); }

bool LuaComponent::configureHook() {
    if (!lua_string_.empty() && !exec_str(lua_string_)) return false;
    if (!lua_file_.empty() && !exec_file(lua_file_)) return false;
    const Answer answer = script_->hook("configureHook", true, lua_timeout_);
    return answer == Answer::Yes || answer == Answer::Missing;
}

bool LuaComponent::activate() {
    const Answer answer = script_->hook("activateHook", true, lua_timeout_);
    return (answer == Answer::Yes || answer == Answer::Missing) && RTT::TaskContext::activate();
}

bool LuaComponent::startHook() {
    const Answer answer = script_->hook("startHook", true, lua_timeout_);
    return answer == Answer::Yes || answer == Answer::Missing;
}

void LuaComponent::updateHook() {
    if (script_->hook("updateHook", false, lua_timeout_) == Answer::Failed) exception();
    script_->collect(lua_gc_budget_);
}

void LuaComponent::errorHook() {
    if (script_->hook("errorHook", false, lua_timeout_) == Answer::Failed) exception();
}

// Lua collects by itself as long as updateHook() does not.
void LuaComponent::stopHook() {
    (void)script_->hook("stopHook", false, lua_timeout_);
    script_->collect(0);
}
void LuaComponent::cleanupHook() { (void)script_->hook("cleanupHook", false, lua_timeout_); }
void LuaComponent::exceptionHook() {
    (void)script_->hook("exceptionHook", false, lua_timeout_);
    script_->collect(0);
}

}  // namespace OCL

ORO_CREATE_COMPONENT(OCL::LuaComponent)
