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
    const luaL_Reg methods[] = {{"getName", &guarded<&name>},
                                {"doc", &guarded<&doc>},
                                {"getProviderNames", &guarded<&Own::providerNames>},
                                {"getOperationNames", &guarded<&Own::operationNames>},
                                {"hasOperation", &guarded<&Own::hasOperation>},
                                {"getPortNames", &guarded<&Own::portNames>},
                                {"provides", &guarded<&Own::provides>},
                                {"getOperation", &guarded<&Own::operation>},
                                {"getOperationInfo", &guarded<&Own::operationInfo>},
                                {"getPort", &guarded<&Own::port>},
                                {"getProperty", &guarded<&Own::property>},
                                {"getProperties", &guarded<&Own::properties>},
                                {"getPropertyNames", &guarded<&Own::propertyNames>},
                                {"getAttribute", &guarded<&Own::attribute>},
                                {"getAttributes", &guarded<&Own::attributes>},
                                {"getAttributeNames", &guarded<&Own::attributeNames>},
                                {nullptr, nullptr}};
    const luaL_Reg events[] = {{"__index", &guarded<&index>}, {"__tostring", &guarded<&describe>}, {nullptr, nullptr}};
    registerKind<ServiceBox>(lua, methods, events);
}

void pushService(lua_State* lua, const RTT::Service::shared_ptr& service) {
    pushBox<ServiceBox>(lua, service, Life(*service));
}

}  // namespace OCL::lua
