// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "bindings.hpp"
#include "box.hpp"
#include "members.hpp"
#include "operation_lookup.hpp"
#include "things.hpp"
#include "values.hpp"

namespace OCL::lua {

namespace {

ServiceBox& self(lua_State* lua) {
    ServiceBox& box = boxAt<ServiceBox>(lua, 1);
    box.life.check(ServiceBox::kName);
    return box;
}

const RTT::Service::shared_ptr serviceOf(lua_State* lua) { return self(lua).service; }

int name(lua_State* lua) {
    pushText(lua, self(lua).service->getName());
    return 1;
}

int doc(lua_State* lua) {
    RTT::Service& service = *self(lua).service;
    if (!lua_isnoneornil(lua, 2)) {
        service.doc(textAt(lua, 2));
        return 0;
    }
    pushText(lua, service.doc());
    return 1;
}

int index(lua_State* lua) { return findMethod(lua, self(lua).service); }

int describe(lua_State* lua) {
    pushText(lua, "Service: " + self(lua).service->getName());
    return 1;
}

}  // namespace

void bindService(lua_State* lua) {
    typedef Members<&serviceOf> Own;
    const luaL_Reg methods[] = {{"getName", &guarded<&inUse<ServiceBox, &name>>},
                                {"doc", &guarded<&inUse<ServiceBox, &doc>>},
                                {"getProviderNames", &guarded<&inUse<ServiceBox, &Own::providerNames>>},
                                {"getOperationNames", &guarded<&inUse<ServiceBox, &Own::operationNames>>},
                                {"hasOperation", &guarded<&inUse<ServiceBox, &Own::hasOperation>>},
                                {"getPortNames", &guarded<&inUse<ServiceBox, &Own::portNames>>},
                                {"provides", &guarded<&inUse<ServiceBox, &Own::provides>>},
                                {"getOperation", &guarded<&inUse<ServiceBox, &Own::operation>>},
                                {"getOperationInfo", &guarded<&inUse<ServiceBox, &Own::operationInfo>>},
                                {"getPort", &guarded<&inUse<ServiceBox, &Own::port>>},
                                {"getProperty", &guarded<&inUse<ServiceBox, &Own::property>>},
                                {"getProperties", &guarded<&inUse<ServiceBox, &Own::properties>>},
                                {"getPropertyNames", &guarded<&inUse<ServiceBox, &Own::propertyNames>>},
                                {"getAttribute", &guarded<&inUse<ServiceBox, &Own::attribute>>},
                                {"getAttributes", &guarded<&inUse<ServiceBox, &Own::attributes>>},
                                {"getAttributeNames", &guarded<&inUse<ServiceBox, &Own::attributeNames>>},
                                {nullptr, nullptr}};
    const luaL_Reg events[] = {{"__index", &guarded<&inUse<ServiceBox, &index>>},
                               {"__tostring", &guarded<&inUse<ServiceBox, &describe>>},
                               {nullptr, nullptr}};
    registerKind<ServiceBox>(lua, methods, events);
}

void pushService(lua_State* lua, const RTT::Service::shared_ptr& service) {
    pushBox<ServiceBox>(lua, service, Life(*service));
}

}  // namespace OCL::lua
