// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What components and services have in common for Lua: ports, properties, attributes and operations by name.
#ifndef OCL_LUA_MEMBERS_HPP
#define OCL_LUA_MEMBERS_HPP

#include "bindings.hpp"
#include "box.hpp"
#include "describe_operation.hpp"
#include "values.hpp"

#include <rtt/PropertyBag.hpp>

namespace OCL::lua {

/** The methods of userdata whose service `Of` gives, from the userdata at index 1. */
template <const RTT::Service::shared_ptr (*Of)(lua_State*)>
struct Members {
    static int portNames(lua_State* lua) {
        pushTexts(lua, Of(lua)->getPortNames());
        return 1;
    }
    static int port(lua_State* lua) {
        pushPort(lua, *Of(lua), textAt(lua, 2));
        return 1;
    }
    static int property(lua_State* lua) {
        const RTT::Service::shared_ptr service = Of(lua);
        const std::string name = textAt(lua, 2);
        RTT::base::PropertyBase* const found = service->getProperty(name);
        if (!found) throw Failure("'" + service->getName() + "' has no property '" + name + "'");
        pushProperty(lua, *service, found);
        return 1;
    }
    static int properties(lua_State* lua) {
        const RTT::Service::shared_ptr service = Of(lua);
        lua_newtable(lua);
        int index = 0;
        for (RTT::base::PropertyBase* const one : service->properties()->getProperties()) {
            pushProperty(lua, *service, one);
            lua_rawseti(lua, -2, ++index);
        }
        return 1;
    }
    static int propertyNames(lua_State* lua) {
        std::vector<std::string> names;
        for (const RTT::base::PropertyBase* const one : Of(lua)->properties()->getProperties())
            names.push_back(one->getName());
        pushTexts(lua, names);
        return 1;
    }
    static int attribute(lua_State* lua) {
        const RTT::Service::shared_ptr service = Of(lua);
        const std::string name = textAt(lua, 2);
        RTT::base::AttributeBase* const found = service->getValue(name);
        if (!found) throw Failure("'" + service->getName() + "' has no attribute '" + name + "'");
        pushAttribute(lua, *service, found);
        return 1;
    }
    static int attributes(lua_State* lua) {
        const RTT::Service::shared_ptr service = Of(lua);
        lua_newtable(lua);
        int index = 0;
        for (RTT::base::AttributeBase* const one : service->getValues()) {
            pushAttribute(lua, *service, one);
            lua_rawseti(lua, -2, ++index);
        }
        return 1;
    }
    static int attributeNames(lua_State* lua) {
        pushTexts(lua, Of(lua)->getAttributeNames());
        return 1;
    }
    static int operationNames(lua_State* lua) {
        pushTexts(lua, Of(lua)->getNames());
        return 1;
    }
    static int hasOperation(lua_State* lua) {
        lua_pushboolean(lua, Of(lua)->getPart(textAt(lua, 2)) != nullptr);
        return 1;
    }
    static int operation(lua_State* lua) {
        pushOperation(lua, Of(lua), textAt(lua, 2));
        return 1;
    }
    static int operationInfo(lua_State* lua) { return pushInfoOf(lua, *Of(lua), textAt(lua, 2)); }
    static int providerNames(lua_State* lua) {
        pushTexts(lua, Of(lua)->getProviderNames());
        return 1;
    }
    static int provides(lua_State* lua) {
        RTT::Service::shared_ptr service = Of(lua);
        for (int i = 2; i <= lua_gettop(lua); ++i) {
            const std::string name = textAt(lua, i);
            RTT::Service::shared_ptr next = service->getService(name);
            if (!next) throw Failure("'" + service->getName() + "' has no service '" + name + "'");
            service = next;
        }
        pushService(lua, service);
        return 1;
    }
};

}  // namespace OCL::lua

#endif
