// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "complete_names.hpp"

#include "box.hpp"
#include "things.hpp"

#include <rtt/PropertyBag.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/types/TypeInfoRepository.hpp>

#include <cctype>

namespace OCL::lua {

namespace {

// A value may have a metatable that refers to another one, and so on, also in a circle.
constexpr int kMostTables = 10;

bool isIdentifier(const std::string& name) {
    if (name.empty() || std::isdigit(static_cast<unsigned char>(name[0]))) return false;
    for (const char c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_') return false;
    return true;
}

/** Replaces the value on top by the table where fields are found that it has not itself; nil if there is none. */
void takeIndex(lua_State* lua) {
    if (!luaL_getmetafield(lua, -1, "__index")) lua_pushnil(lua);
    lua_remove(lua, -2);
    // Functions for userdata of this library have the table of their methods.
    if (lua_iscfunction(lua, -1)) {
        if (!lua_getupvalue(lua, -1, 1)) lua_pushnil(lua);
        lua_remove(lua, -2);
    }
    if (lua_istable(lua, -1)) return;
    lua_pop(lua, 1);
    lua_pushnil(lua);
}

void addFields(lua_State* lua, Names& names) {
    lua_pushnil(lua);
    while (lua_next(lua, -2)) {
        if (lua_type(lua, -2) == LUA_TSTRING) {
            const std::string name = lua_tostring(lua, -2);
            if (isIdentifier(name)) names.emplace(name, lua_isfunction(lua, -1));
        }
        lua_pop(lua, 1);
    }
}

void add(Names& names, const std::vector<std::string>& more, bool areFunctions) {
    for (const std::string& name : more) names.emplace(name, areFunctions);
}

/** The service of a component or service; null for anything else, or if its component is gone. */
RTT::Service::shared_ptr serviceAt(lua_State* lua) {
    const TaskBox* const task = findBox<TaskBox>(lua, -1);
    if (task && !task->life.isOver()) return task->component->provides();
    const ServiceBox* const service = findBox<ServiceBox>(lua, -1);
    return service && !service->life.isOver() ? service->service : nullptr;
}

const Variable* variableAt(lua_State* lua) {
    const Variable* const variable = findBox<Variable>(lua, -1);
    return variable && !variable->life.isOver() ? variable : nullptr;
}

bool contains(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

std::vector<std::string> propertyNames(RTT::Service& service) {
    std::vector<std::string> names;
    for (const RTT::base::PropertyBase* const one : service.properties()->getProperties())
        names.push_back(one->getName());
    return names;
}

std::vector<std::string> namesFor(RTT::Service& service, const std::string& called) {
    if (contains(called, "Port")) return service.getPortNames();
    if (contains(called, "Property")) return propertyNames(service);
    if (contains(called, "Attribute")) return service.getAttributeNames();
    if (contains(called, "Op")) return service.getNames();
    if (called == "provides") return service.getProviderNames();
    return {};
}

}  // namespace

void takeField(lua_State* lua, const std::string& name) {
    if (lua_isuserdata(lua, -1) && (variableAt(lua) || serviceAt(lua))) {
        lua_getfield(lua, -1, name.c_str());
        lua_remove(lua, -2);
        return;
    }
    for (int i = 0; i != kMostTables && !lua_isnil(lua, -1); ++i) {
        if (lua_istable(lua, -1)) {
            lua_pushlstring(lua, name.data(), name.size());
            lua_rawget(lua, -2);
            if (!lua_isnil(lua, -1)) {
                lua_remove(lua, -2);
                return;
            }
            lua_pop(lua, 1);
        }
        takeIndex(lua);
    }
    lua_pop(lua, 1);
    lua_pushnil(lua);
}

Names namesOf(lua_State* lua) {
    Names names;
    if (const RTT::Service::shared_ptr service = serviceAt(lua)) add(names, service->getNames(), true);
    if (const Variable* const variable = variableAt(lua)) add(names, variable->source->getMemberNames(), false);
    lua_pushvalue(lua, -1);
    for (int i = 0; i != kMostTables && !lua_isnil(lua, -1); ++i) {
        if (lua_istable(lua, -1)) addFields(lua, names);
        takeIndex(lua);
    }
    lua_pop(lua, 1);
    return names;
}

std::vector<std::string> argumentsOf(lua_State* lua, const std::string& called) {
    if (const RTT::Service::shared_ptr service = serviceAt(lua)) {
        std::vector<std::string> names = namesFor(*service, called);
        const TaskBox* const task = findBox<TaskBox>(lua, -1);
        if (!task || !names.empty()) return names;
        // Most operations of a deployer take names of its peers.
        return called == "requires" ? task->component->requires_()->getRequesterNames()
                                    : task->component->getPeerList();
    }
    if (const Variable* const variable = variableAt(lua)) return variable->source->getMemberNames();
    if (lua_istable(lua, -1) && (called == "new" || called == "Variable" || contains(called, "Port")))
        return RTT::types::Types()->getTypes();
    return {};
}

}  // namespace OCL::lua
