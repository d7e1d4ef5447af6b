// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Components.
#include "bindings.hpp"
#include "box.hpp"
#include "members.hpp"
#include "operation_lookup.hpp"
#include "owned_things.hpp"
#include "port_access.hpp"
#include "provided_operation.hpp"
#include "push_requester.hpp"
#include "state.hpp"
#include "things.hpp"
#include "values.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/TaskContext.hpp>

#include <boost/weak_ptr.hpp>

namespace OCL::lua {

using RTT::TaskContext;

namespace {

TaskContext& taskAt(lua_State* lua, int index) {
    TaskBox& box = boxAt<TaskBox>(lua, index);
    box.life.check(TaskBox::kName);
    return *box.component;
}

TaskContext& self(lua_State* lua) { return taskAt(lua, 1); }

const RTT::Service::shared_ptr serviceOf(lua_State* lua) { return self(lua).provides(); }

int name(lua_State* lua) {
    pushText(lua, self(lua).getName());
    return 1;
}

/** A member function that may call hooks of the component, which may wait for Lua code of other threads. */
template <auto Function>
int change(lua_State* lua) {
    TaskContext& component = self(lua);
    bool done;
    {
        const State::Leave leave(State::of(lua));
        done = (component.*Function)();
    }
    lua_pushboolean(lua, done);
    return 1;
}

int error(lua_State* lua) {
    TaskContext& component = self(lua);
    const State::Leave leave(State::of(lua));
    component.error();
    return 0;
}

int stateName(lua_State* lua) {
    const char* const names[] = {"Init",    "PreOperational", "FatalError",  "Exception",
                                 "Stopped", "Running",        "RunTimeError"};
    lua_pushstring(lua, names[self(lua).getTaskState()]);
    return 1;
}

int peers(lua_State* lua) {
    pushTexts(lua, self(lua).getPeerList());
    return 1;
}

int addPeer(lua_State* lua) {
    lua_pushboolean(lua, self(lua).addPeer(&taskAt(lua, 2), textAt(lua, 3, "")));
    return 1;
}

int removePeer(lua_State* lua) {
    self(lua).removePeer(textAt(lua, 2));
    return 0;
}

int peer(lua_State* lua) {
    TaskContext& component = self(lua);
    const std::string wanted = textAt(lua, 2);
    TaskContext* const found = component.getPeer(wanted);
    if (!found) throw Failure("component '" + component.getName() + "' has no peer '" + wanted + "'");
    pushTask(lua, *found);
    return 1;
}

template <bool (TaskContext::*Connect)(TaskContext*)>
int connectBy(lua_State* lua) {
    TaskContext &component = self(lua), &other = taskAt(lua, 2);
    bool done;
    {
        const State::Leave leave(State::of(lua));
        done = (component.*Connect)(&other);
    }
    lua_pushboolean(lua, done);
    return 1;
}

int connectPeers(lua_State* lua) { return connectBy<&TaskContext::connectPeers>(lua); }

int connectPorts(lua_State* lua) { return connectBy<&TaskContext::connectPorts>(lua); }

int connectServices(lua_State* lua) { return connectBy<&TaskContext::connectServices>(lua); }

/** Names and describes the port at index 2 as the arguments behind it say. */
RTT::base::PortInterface& portToAdd(lua_State* lua) {
    RTT::base::PortInterface& port = ownPortAt(lua, 2);
    const std::string wanted = textAt(lua, 3, ""), description = textAt(lua, 4, "");
    if (!wanted.empty() && wanted != port.getName() && !port.setName(wanted))
        throw Failure("port '" + port.getName() + "' is connected and cannot be renamed to '" + wanted + "'");
    if (port.getName().empty()) throw Failure("a port needs a name before it is added");
    if (!description.empty()) port.doc(description);
    return port;
}

int addPort(lua_State* lua) {
    TaskContext& component = self(lua);
    RTT::base::PortInterface& port = portToAdd(lua);
    component.addPort(port);
    // A port leaves its component by itself.
    State::of(lua).owned().use(&port, [] {});
    return 0;
}

int addEventPort(lua_State* lua) {
    TaskContext& component = self(lua);
    RTT::base::InputPortInterface* const port = portToAdd(lua).asInput();
    if (!port) throw Failure("only input ports can be event ports");
    component.addEventPort(*port);
    State::of(lua).owned().use(port, [] {});
    return 0;
}

int removePort(lua_State* lua) {
    TaskContext& component = self(lua);
    const std::string wanted = textAt(lua, 2);
    RTT::base::PortInterface* const port = component.getPort(wanted);
    if (!port) throw Failure("component '" + component.getName() + "' has no port '" + wanted + "'");
    {
        const State::Leave leave(State::of(lua));
        component.ports()->removePort(wanted);
    }
    State::of(lua).owned().unuse(port);
    return 0;
}

int addProperty(lua_State* lua) {
    TaskContext& component = self(lua);
    RTT::base::PropertyBase& property = ownPropertyAt(lua, 2);
    OwnedThings& owned = State::of(lua).owned();
    if (owned.isUsed(&property))
        throw Failure("property '" + property.getName() + "' is in a component already; removeProperty() comes first");
    const std::string wanted = textAt(lua, 3, ""), description = textAt(lua, 4, "");
    if (!wanted.empty()) property.setName(wanted);
    if (!description.empty()) property.setDescription(description);
    if (property.getName().empty()) throw Failure("a property needs a name before it is added");
    if (!component.addProperty(property))
        throw Failure("component '" + component.getName() + "' has a property '" + property.getName() + "' already");
    owned.use(&property, [home = boost::weak_ptr<RTT::Service>(component.provides()), added = &property] {
        if (const RTT::Service::shared_ptr service = home.lock()) service->properties()->removeProperty(added);
    });
    return 0;
}

int removeProperty(lua_State* lua) {
    TaskContext& component = self(lua);
    const std::string wanted = textAt(lua, 2);
    RTT::base::PropertyBase* const found = component.getProperty(wanted);
    if (!found) throw Failure("component '" + component.getName() + "' has no property '" + wanted + "'");
    component.properties()->removeProperty(found);
    State::of(lua).owned().unuse(found);
    return 0;
}

int addAttribute(lua_State* lua) {
    TaskContext& component = self(lua);
    RTT::base::AttributeBase& attribute = ownAttributeAt(lua, 2);
    const std::string wanted = textAt(lua, 3, "");
    if (!wanted.empty()) attribute.setName(wanted);
    if (!component.addAttribute(attribute))
        throw Failure("component '" + component.getName() + "' has no room for attribute '" + attribute.getName() +
                      "': it needs a name of its own");
    State::of(lua).owned().give(component.provides()->getValues().back());
    return 0;
}

int removeAttribute(lua_State* lua) {
    TaskContext& component = self(lua);
    const std::string wanted = textAt(lua, 2);
    (void)State::of(lua).owned().takeGiven(component.provides()->getValue(wanted));
    if (!component.attributes()->removeAttribute(wanted))
        throw Failure("component '" + component.getName() + "' has no attribute '" + wanted + "'");
    return 0;
}

int addOperation(lua_State* lua) {
    TaskContext& component = self(lua);
    provideOperation(lua, *component.provides());
    return 0;
}

int removeOperation(lua_State* lua) {
    TaskContext& component = self(lua);
    const std::string wanted = textAt(lua, 2);
    if (!isProvidedHere(lua, component.provides()->getPart(wanted)))
        throw Failure("no Lua code gave component '" + component.getName() + "' an operation '" + wanted + "'");
    component.provides()->removeOperation(wanted);
    return 0;
}

int loadService(lua_State* lua) {
    TaskContext& component = self(lua);
    const std::string wanted = textAt(lua, 2);
    bool done;
    {
        const State::Leave leave(State::of(lua));
        done = component.loadService(wanted);
    }
    lua_pushboolean(lua, done);
    return 1;
}

int requires_(lua_State* lua) {
    TaskContext& component = self(lua);
    return pushRequester(lua, component.requires_(), Life(component));
}

/** Only the deployer that loaded a component can destroy it. Null if this component and its peers know of none. */
TaskContext* deployerOf(TaskContext& own, const std::string& component) {
    const auto canUnload = [&](TaskContext& one) {
        return one.provides()->getPart("unloadComponent") && one.hasPeer(component);
    };
    if (canUnload(own)) return &own;
    for (const std::string& peer : own.getPeerList()) {
        TaskContext* const known = own.getPeer(peer);
        if (known && canUnload(*known)) return known;
    }
    return nullptr;
}

int remove(lua_State* lua) {
    TaskContext& component = self(lua);
    const std::string unwanted = component.getName();
    State& state = State::of(lua);
    if (&component == &state.owner()) throw Failure("a component cannot delete itself");
    TaskContext* const deployer = deployerOf(state.owner(), unwanted);
    if (!deployer) throw Failure("component '" + unwanted + "' was loaded by no deployer that is a peer");
    RTT::OperationCaller<bool(const std::string&)> unload(deployer->getOperation("unloadComponent"));
    bool done;
    {
        const State::Leave leave(state);
        done = unload.ready() && unload(unwanted);
    }
    if (!done) throw Failure("component '" + unwanted + "' could not be unloaded; see the log");
    destroyBox<TaskBox>(lua, 1);
    return 0;
}

int index(lua_State* lua) { return findMethod(lua, self(lua).provides()); }

int isSame(lua_State* lua) {
    const TaskBox* const a = findBox<TaskBox>(lua, 1);
    const TaskBox* const b = findBox<TaskBox>(lua, 2);
    lua_pushboolean(lua, a && b && a->component == b->component);
    return 1;
}

int describe(lua_State* lua) {
    pushText(lua, "TaskContext: " + self(lua).getName());
    return 1;
}

}  // namespace

void bindTask(lua_State* lua) {
    typedef Members<&serviceOf> Own;
    const luaL_Reg methods[] = {{"getName", &guarded<&inUse<TaskBox, &name>>},
                                {"start", &guarded<&inUse<TaskBox, &change<&TaskContext::start>>>},
                                {"stop", &guarded<&inUse<TaskBox, &change<&TaskContext::stop>>>},
                                {"configure", &guarded<&inUse<TaskBox, &change<&TaskContext::configure>>>},
                                {"activate", &guarded<&inUse<TaskBox, &change<&TaskContext::activate>>>},
                                {"cleanup", &guarded<&inUse<TaskBox, &change<&TaskContext::cleanup>>>},
                                {"recover", &guarded<&inUse<TaskBox, &change<&TaskContext::recover>>>},
                                {"error", &guarded<&inUse<TaskBox, &error>>},
                                {"getState", &guarded<&inUse<TaskBox, &stateName>>},
                                {"getPeers", &guarded<&inUse<TaskBox, &peers>>},
                                {"addPeer", &guarded<&inUse<TaskBox, &addPeer>>},
                                {"removePeer", &guarded<&inUse<TaskBox, &removePeer>>},
                                {"getPeer", &guarded<&inUse<TaskBox, &peer>>},
                                {"connectPeers", &guarded<&inUse<TaskBox, &connectPeers>>},
                                {"connectPorts", &guarded<&inUse<TaskBox, &connectPorts>>},
                                {"connectServices", &guarded<&inUse<TaskBox, &connectServices>>},
                                {"getPortNames", &guarded<&inUse<TaskBox, &Own::portNames>>},
                                {"addPort", &guarded<&inUse<TaskBox, &addPort>>},
                                {"addEventPort", &guarded<&inUse<TaskBox, &addEventPort>>},
                                {"getPort", &guarded<&inUse<TaskBox, &Own::port>>},
                                {"removePort", &guarded<&inUse<TaskBox, &removePort>>},
                                {"addProperty", &guarded<&inUse<TaskBox, &addProperty>>},
                                {"getProperty", &guarded<&inUse<TaskBox, &Own::property>>},
                                {"getProperties", &guarded<&inUse<TaskBox, &Own::properties>>},
                                {"getPropertyNames", &guarded<&inUse<TaskBox, &Own::propertyNames>>},
                                {"removeProperty", &guarded<&inUse<TaskBox, &removeProperty>>},
                                {"addAttribute", &guarded<&inUse<TaskBox, &addAttribute>>},
                                {"getAttribute", &guarded<&inUse<TaskBox, &Own::attribute>>},
                                {"getAttributes", &guarded<&inUse<TaskBox, &Own::attributes>>},
                                {"getAttributeNames", &guarded<&inUse<TaskBox, &Own::attributeNames>>},
                                {"removeAttribute", &guarded<&inUse<TaskBox, &removeAttribute>>},
                                {"addOperation", &guarded<&inUse<TaskBox, &addOperation>>},
                                {"removeOperation", &guarded<&inUse<TaskBox, &removeOperation>>},
                                {"getOps", &guarded<&inUse<TaskBox, &Own::operationNames>>},
                                {"getOpInfo", &guarded<&inUse<TaskBox, &Own::operationInfo>>},
                                {"getOperationInfo", &guarded<&inUse<TaskBox, &Own::operationInfo>>},
                                {"hasOperation", &guarded<&inUse<TaskBox, &Own::hasOperation>>},
                                {"getOperation", &guarded<&inUse<TaskBox, &Own::operation>>},
                                {"loadService", &guarded<&inUse<TaskBox, &loadService>>},
                                {"provides", &guarded<&inUse<TaskBox, &Own::provides>>},
                                {"getProviderNames", &guarded<&inUse<TaskBox, &Own::providerNames>>},
                                {"requires", &guarded<&inUse<TaskBox, &requires_>>},
                                {"delete", &guarded<&inUse<TaskBox, &remove>>},
                                {nullptr, nullptr}};
    const luaL_Reg events[] = {{"__index", &guarded<&inUse<TaskBox, &index>>},
                               {"__eq", &guarded<&inUse<TaskBox, &isSame>>},
                               {"__tostring", &guarded<&inUse<TaskBox, &describe>>},
                               {nullptr, nullptr}};
    registerKind<TaskBox>(lua, methods, events);
}

void pushTask(lua_State* lua, TaskContext& component) { pushBox<TaskBox>(lua, &component, Life(component)); }

}  // namespace OCL::lua
