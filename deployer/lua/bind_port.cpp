// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Ports.
#include "bindings.hpp"
#include "box.hpp"
#include "busy.hpp"
#include "collect_held.hpp"
#include "conversion.hpp"
#include "owned_things.hpp"
#include "port_access.hpp"
#include "state.hpp"
#include "things.hpp"
#include "values.hpp"

#include <rtt/ConnPolicy.hpp>
#include <rtt/FlowStatus.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/types/TypeInfo.hpp>

namespace OCL::lua {

using RTT::base::InputPortInterface;
using RTT::base::OutputPortInterface;
using RTT::base::PortInterface;

namespace {

/** The port at `index`, which still exists. */
template <class Box>
Box& portBox(lua_State* lua, int index) {
    Box& box = boxAt<Box>(lua, index);
    box.life.check("port");
    if (box.exists) {
        if (!*box.exists) throw Failure("this port was deleted");
        return box;
    }
    const RTT::Service::shared_ptr home = box.home.lock();
    if (!home || home->getPort(box.name) != box.thing)
        throw Failure("port '" + box.name + "' is no longer in its component");
    return box;
}

const char* nameOf(RTT::FlowStatus status) {
    return status == RTT::NewData ? "NewData" : status == RTT::OldData ? "OldData" : "NoData";
}

int read(lua_State* lua) {
    InputPort& port = portBox<InputPort>(lua, 1);
    if (lua_gettop(lua) > 1) {
        const Variable& into = boxAt<Variable>(lua, 2);
        into.life.check(Variable::kName);
        if (into.source->getTypeInfo() != port.thing->getTypeInfo())
            throw Failure("port '" + port.thing->getName() + "' has samples of type " + port.conversion->typeName() +
                          ", but the Variable is a " + into.source->getTypeName());
        lua_pushstring(lua, nameOf(port.thing->read(into.source)));
        return 1;
    }
    const RTT::FlowStatus status = port.thing->read(port.sample->value);
    lua_pushstring(lua, nameOf(status));
    // Scripts use the value without looking at the status.
    pushCopy(lua, *port.conversion, status == RTT::NoData ? *port.nothing : *port.sample->value);
    return 2;
}

/** Others may be inside meanwhile: a component that is executed by those that write to it may call Lua code. */
void writeLeaving(lua_State* lua, OutputPortInterface& port, const RTT::base::DataSourceBase::shared_ptr& value) {
    const State::Leave leave(State::of(lua));
    port.write(value);
}

int write(lua_State* lua) {
    OutputPort& port = portBox<OutputPort>(lua, 1);
    luaL_checkany(lua, 2);
    const Variable* const variable = findBox<Variable>(lua, 2);
    if (variable && variable->source->getTypeInfo() == port.thing->getTypeInfo()) {
        variable->life.check(Variable::kName);
        writeLeaving(lua, *port.thing, RTT::base::DataSourceBase::shared_ptr(variable->source));
        return 0;
    }
    const std::shared_ptr<Sample> sample = port.sample;
    if (sample->busy) {
        const RTT::base::DataSourceBase::shared_ptr other = port.thing->getTypeInfo()->buildValue();
        assign(lua, 2, *other);
        writeLeaving(lua, *port.thing, other);
        return 0;
    }
    assign(lua, 2, *sample->value);
    const Busy busy(sample->busy);
    writeLeaving(lua, *port.thing, sample->value);
    return 0;
}

template <class Box>
int info(lua_State* lua) {
    const Box& box = portBox<Box>(lua, 1);
    lua_newtable(lua);
    setField(lua, "name", box.thing->getName());
    setField(lua, "desc", box.thing->getDescription());
    setField(lua, "type", box.conversion->typeName());
    setField(lua, "porttype", std::is_same_v<Box, InputPort> ? "in" : "out");
    lua_pushboolean(lua, box.thing->connected());
    lua_setfield(lua, -2, "connected");
    lua_pushboolean(lua, box.thing->isLocal());
    lua_setfield(lua, -2, "isLocal");
    return 1;
}

/** The policy at `index`: a Variable, or a table of its members. Null if there is none. */
RTT::base::DataSourceBase::shared_ptr policyAt(lua_State* lua, int index) {
    if (lua_isnoneornil(lua, index)) return nullptr;
    const RTT::base::DataSourceBase::shared_ptr policy(
        new RTT::internal::ValueDataSource<RTT::ConnPolicy>(RTT::ConnPolicy()));
    assign(lua, index, *policy);
    return policy;
}

template <class Box>
int connect(lua_State* lua) {
    PortInterface& from = *portBox<Box>(lua, 1).thing;
    PortInterface& to = portAt(lua, 2);
    const RTT::base::DataSourceBase::shared_ptr policy = policyAt(lua, 3);
    bool done;
    {
        const State::Leave leave(State::of(lua));
        done = policy ? from.connectTo(&to, *static_cast<const RTT::ConnPolicy*>(policy->getRawConstPointer()))
                      : from.connectTo(&to);
    }
    lua_pushboolean(lua, done);
    return 1;
}

template <class Box>
int disconnect(lua_State* lua) {
    PortInterface& port = *portBox<Box>(lua, 1).thing;
    PortInterface* const other = lua_isnoneornil(lua, 2) ? nullptr : &portAt(lua, 2);
    bool done = true;
    {
        const State::Leave leave(State::of(lua));
        if (other)
            done = port.disconnect(other);
        else
            port.disconnect();
    }
    lua_pushboolean(lua, done);
    return 1;
}

template <class Box>
int remove(lua_State* lua) {
    Box& box = portBox<Box>(lua, 1);
    const auto destroy = State::of(lua).owned().take(box.thing);
    if (!destroy)
        throw Failure("port '" + box.thing->getName() + "' belongs to its component, which alone can delete it");
    {
        const State::Leave leave(State::of(lua));
        destroy();
    }
    destroyBox<Box>(lua, 1);
    return 0;
}

template <class Box>
int describe(lua_State* lua) {
    const Box& box = portBox<Box>(lua, 1);
    pushText(lua, box.thing->getName() + " [" + (std::is_same_v<Box, InputPort> ? "in" : "out") + ", " +
                      box.conversion->typeName() + ", " + (box.thing->connected() ? "conn" : "unconn") + ", " +
                      (box.thing->isLocal() ? "local" : "nonlocal") + "] // " + box.thing->getDescription());
    return 1;
}

template <class Box, class Port>
void push(lua_State* lua, Held<Port> held) {
    const RTT::types::TypeInfo* const type = held.thing->getTypeInfo();
    const Conversion* const conversion = &State::of(lua).conversion(type);
    const auto sample = std::make_shared<Sample>(Sample{type->buildValue(), false});
    if constexpr (std::is_same_v<Box, InputPort>)
        pushBox<Box>(lua, std::move(held), sample, conversion, type->buildValue());
    else
        pushBox<Box>(lua, std::move(held), sample, conversion);
}

template <class Box, class Port>
int make(lua_State* lua, Port* (RTT::types::TypeInfo::*build)(const std::string&) const) {
    const RTT::types::TypeInfo& type = typeNamed(textAt(lua, 1));
    const std::string name = textAt(lua, 2, ""), description = textAt(lua, 3, "");
    State::of(lua).makeRoom();
    std::unique_ptr<Port> made((type.*build)(name));
    if (!made) throw Failure("type '" + type.getTypeName() + "' has no ports");
    if (!description.empty()) made->doc(description);
    Port* const plain = made.release();
    push<Box>(lua, Held<Port>{plain, Life(), {}, "", State::of(lua).owned().add(plain)});
    return 1;
}

int makeInput(lua_State* lua) { return make<InputPort>(lua, &RTT::types::TypeInfo::inputPort); }
int makeOutput(lua_State* lua) { return make<OutputPort>(lua, &RTT::types::TypeInfo::outputPort); }

template <class Box, int (*Make)(lua_State*), int (*Use)(lua_State*)>
void bind(lua_State* lua, const char* use) {
    const luaL_Reg methods[] = {{"new", &guarded<Make>},
                                {use, &guarded<&inUse<Box, Use>>},
                                {"info", &guarded<&inUse<Box, &info<Box>>>},
                                {"connect", &guarded<&inUse<Box, &connect<Box>>>},
                                {"disconnect", &guarded<&inUse<Box, &disconnect<Box>>>},
                                {"delete", &guarded<&inUse<Box, &remove<Box>>>},
                                {nullptr, nullptr}};
    const luaL_Reg events[] = {{"__tostring", &guarded<&inUse<Box, &describe<Box>>>},
                               {"__gc", &guarded<&collectHeld<Box>>},
                               {nullptr, nullptr}};
    registerKind<Box>(lua, methods, events);
}

}  // namespace

PortInterface& portAt(lua_State* lua, int index) {
    if (findBox<InputPort>(lua, index)) return *portBox<InputPort>(lua, index).thing;
    if (findBox<OutputPort>(lua, index)) return *portBox<OutputPort>(lua, index).thing;
    detail::wrongKind(lua, index, "port");
}

PortInterface& ownPortAt(lua_State* lua, int index) {
    PortInterface& port = portAt(lua, index);
    const InputPort* const input = findBox<InputPort>(lua, index);
    if (!(input ? input->exists : findBox<OutputPort>(lua, index)->exists))
        throw Failure("only a port that this Lua code has made can be added");
    return port;
}

void bindInputPort(lua_State* lua) { bind<InputPort, &makeInput, &read>(lua, "read"); }
void bindOutputPort(lua_State* lua) { bind<OutputPort, &makeOutput, &write>(lua, "write"); }

void pushPort(lua_State* lua, RTT::Service& home, const std::string& name) {
    PortInterface* const port = home.getPort(name);
    if (!port) throw Failure("'" + home.getName() + "' has no port '" + name + "'");
    if (InputPortInterface* const input = port->asInput())
        return push<InputPort, InputPortInterface>(lua, {input, Life(home), home.shared_from_this(), name, nullptr});
    push<OutputPort, OutputPortInterface>(lua, {port->asOutput(), Life(home), home.shared_from_this(), name, nullptr});
}

}  // namespace OCL::lua
