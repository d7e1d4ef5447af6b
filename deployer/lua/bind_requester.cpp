// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "bindings.hpp"
#include "box.hpp"
#include "push_requester.hpp"
#include "things.hpp"
#include "values.hpp"

#include <rtt/TaskContext.hpp>

namespace OCL::lua {

namespace {

RequesterBox& self(lua_State* lua) {
    RequesterBox& box = boxAt<RequesterBox>(lua, 1);
    box.life.check(RequesterBox::kName);
    return box;
}

int name(lua_State* lua) {
    pushText(lua, self(lua).requester->getRequestName());
    return 1;
}

int requesterNames(lua_State* lua) {
    pushTexts(lua, self(lua).requester->getRequesterNames());
    return 1;
}

int operationNames(lua_State* lua) {
    pushTexts(lua, self(lua).requester->getOperationCallerNames());
    return 1;
}

int ready(lua_State* lua) {
    lua_pushboolean(lua, self(lua).requester->ready());
    return 1;
}

int disconnect(lua_State* lua) {
    self(lua).requester->disconnect();
    return 0;
}

int connectTo(lua_State* lua) {
    const ServiceBox& service = boxAt<ServiceBox>(lua, 2);
    service.life.check(ServiceBox::kName);
    lua_pushboolean(lua, self(lua).requester->connectTo(service.service));
    return 1;
}

int requires_(lua_State* lua) {
    const RequesterBox& box = self(lua);
    return pushRequester(lua, box.requester, box.life);
}

int describe(lua_State* lua) {
    const RTT::ServiceRequester& requester = *self(lua).requester;
    pushText(lua,
             "ServiceRequester: " + requester.getRequestName() + (requester.ready() ? " (ready)" : " (not ready)"));
    return 1;
}

}  // namespace

int pushRequester(lua_State* lua, RTT::ServiceRequester::shared_ptr requester, const Life& life) {
    for (int i = 2; i <= lua_gettop(lua); ++i) {
        const std::string wanted = textAt(lua, i);
        if (!requester->requiresService(wanted))
            throw Failure("'" + requester->getRequestName() + "' requires no service '" + wanted + "'");
        requester = requester->requires_(wanted);
    }
    pushBox<RequesterBox>(lua, requester, life);
    return 1;
}

void bindRequester(lua_State* lua) {
    const luaL_Reg methods[] = {{"getRequestName", &guarded<&inUse<RequesterBox, &name>>},
                                {"getRequesterNames", &guarded<&inUse<RequesterBox, &requesterNames>>},
                                {"getOperationCallerNames", &guarded<&inUse<RequesterBox, &operationNames>>},
                                {"ready", &guarded<&inUse<RequesterBox, &ready>>},
                                {"disconnect", &guarded<&inUse<RequesterBox, &disconnect>>},
                                {"connectTo", &guarded<&inUse<RequesterBox, &connectTo>>},
                                {"requires", &guarded<&inUse<RequesterBox, &requires_>>},
                                {nullptr, nullptr}};
    const luaL_Reg events[] = {{"__tostring", &guarded<&inUse<RequesterBox, &describe>>}, {nullptr, nullptr}};
    registerKind<RequesterBox>(lua, methods, events);
}

}  // namespace OCL::lua
