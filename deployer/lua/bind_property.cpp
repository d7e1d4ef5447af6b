// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Properties and attributes.
#include "bindings.hpp"
#include "box.hpp"
#include "collect_held.hpp"
#include "conversion.hpp"
#include "member_access.hpp"
#include "owned_things.hpp"
#include "state.hpp"
#include "things.hpp"
#include "values.hpp"

#include <rtt/PropertyBag.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/types/TypeInfo.hpp>

namespace OCL::lua {

using RTT::base::AttributeBase;
using RTT::base::DataSourceBase;
using RTT::base::PropertyBase;
typedef DataSourceBase::shared_ptr Source;

namespace {

bool isStillIn(RTT::Service& home, const Property& property) {
    return home.properties()->find(property.name) == property.thing;
}

bool isStillIn(RTT::Service& home, const Attribute& attribute) {
    return home.getValue(attribute.name) == attribute.thing;
}

/** The property or attribute at this index, which still exists. */
template <class Box>
Box& existing(lua_State* lua, int index) {
    Box& box = boxAt<Box>(lua, index);
    box.life.check(Box::kName);
    if (box.exists) {
        if (!*box.exists) throw Failure(std::string("this ") + Box::kName + " was deleted");
        return box;
    }
    const RTT::Service::shared_ptr home = box.home.lock();
    if (!home || !isStillIn(*home, box))
        throw Failure(std::string(Box::kName) + " '" + box.name + "' is no longer in its component");
    return box;
}

template <class Box>
Box& self(lua_State* lua) {
    return existing<Box>(lua, 1);
}

/** The same, made by this Lua code. Others belong to a component that may end before the one that gets them. */
template <class Box>
Box& ownAt(lua_State* lua, int index) {
    Box& box = existing<Box>(lua, index);
    if (!box.exists) throw Failure(std::string("only a ") + Box::kName + " that this Lua code has made can be added");
    return box;
}

template <class Box>
Source valueOf(const Box& box) {
    Source value = box.thing->getDataSource();
    if (!value) throw Failure(std::string("this ") + Box::kName + " has no value");
    return value;
}

template <class Box>
int get(lua_State* lua) {
    const Box& box = self<Box>(lua);
    pushValue(lua, valueOf(box), box.life);
    return 1;
}

template <class Box>
int getRaw(lua_State* lua) {
    const Box& box = self<Box>(lua);
    pushBox<Variable>(lua, valueOf(box), box.life);
    return 1;
}

template <class Box>
int set(lua_State* lua) {
    luaL_checkany(lua, 2);
    assign(lua, 2, *valueOf(self<Box>(lua)));
    return 0;
}

/** A component has a copy of an attribute that it was given. */
bool removeGiven(OwnedThings& owned, const Attribute& attribute) {
    const RTT::Service::shared_ptr home = attribute.home.lock();
    return home && owned.takeGiven(attribute.thing) && home->removeAttribute(attribute.name);
}

bool removeGiven(OwnedThings&, const Property&) { return false; }

template <class Box>
int remove(lua_State* lua) {
    Box& box = self<Box>(lua);
    OwnedThings& owned = State::of(lua).owned();
    if (removeGiven(owned, box)) {
        destroyBox<Box>(lua, 1);
        return 0;
    }
    const auto destroy = owned.take(box.thing);
    if (!destroy)
        throw Failure(std::string("this ") + Box::kName + " belongs to its component, which alone can delete it");
    destroy();
    destroyBox<Box>(lua, 1);
    return 0;
}

std::string typeOf(const Source& value) { return value ? value->getTypeName() : "unknown_t"; }

int propertyInfo(lua_State* lua) {
    const Property& property = self<Property>(lua);
    lua_newtable(lua);
    setField(lua, "name", property.thing->getName());
    setField(lua, "desc", property.thing->getDescription());
    setField(lua, "type", typeOf(property.thing->getDataSource()));
    return 1;
}

int attributeInfo(lua_State* lua) {
    const Attribute& attribute = self<Attribute>(lua);
    lua_newtable(lua);
    setField(lua, "name", attribute.thing->getName());
    setField(lua, "type", typeOf(attribute.thing->getDataSource()));
    return 1;
}

int makeProperty(lua_State* lua) {
    const RTT::types::TypeInfo& type = typeNamed(textAt(lua, 1));
    const std::string name = textAt(lua, 2, ""), description = textAt(lua, 3, "");
    State::of(lua).makeRoom();
    std::unique_ptr<PropertyBase> made(type.buildProperty(name, description));
    if (!made) throw Failure("type '" + type.getTypeName() + "' has no properties");
    PropertyBase* const plain = made.release();
    pushBox<Property>(lua, Held<PropertyBase>{plain, Life(), {}, "", State::of(lua).owned().add(plain)});
    return 1;
}

int makeAttribute(lua_State* lua) {
    const RTT::types::TypeInfo& type = typeNamed(textAt(lua, 1));
    State::of(lua).makeRoom();
    std::unique_ptr<AttributeBase> made(type.buildAttribute(textAt(lua, 2, "")));
    if (!made) throw Failure("type '" + type.getTypeName() + "' has no attributes");
    AttributeBase* const plain = made.release();
    pushBox<Attribute>(lua, Held<AttributeBase>{plain, Life(), {}, "", State::of(lua).owned().add(plain)});
    return 1;
}

template <class Box>
int member(lua_State* lua) {
    const Box& box = self<Box>(lua);
    pushValue(lua, memberAt(lua, 2, valueOf(box)), box.life);
    return 1;
}

template <class Box>
int index(lua_State* lua) {
    lua_pushvalue(lua, 2);
    lua_rawget(lua, lua_upvalueindex(1));
    return lua_isnil(lua, -1) ? inUse<Box, &member<Box>>(lua) : 1;
}

template <class Box>
int setIndex(lua_State* lua) {
    assign(lua, 3, *memberAt(lua, 2, valueOf(self<Box>(lua))));
    return 0;
}

template <class Box>
int describe(lua_State* lua) {
    const Box& box = self<Box>(lua);
    const Source value = box.thing->getDataSource();
    if (value) (void)value->evaluate();
    std::string text = box.thing->getName() + " (" + typeOf(value) + ") = " + (value ? value->toString() : "nothing");
    if constexpr (std::is_same_v<Box, Property>) text += " // " + box.thing->getDescription();
    pushText(lua, text);
    return 1;
}

template <class Box, int (*Make)(lua_State*), int (*Info)(lua_State*)>
void bind(lua_State* lua) {
    const luaL_Reg methods[] = {{"new", &guarded<Make>},
                                {"get", &guarded<&inUse<Box, &get<Box>>>},
                                {"getRaw", &guarded<&inUse<Box, &getRaw<Box>>>},
                                {"set", &guarded<&inUse<Box, &set<Box>>>},
                                {"info", &guarded<&inUse<Box, Info>>},
                                {"delete", &guarded<&inUse<Box, &remove<Box>>>},
                                {nullptr, nullptr}};
    const luaL_Reg events[] = {{"__index", &guarded<&index<Box>>},
                               {"__newindex", &guarded<&inUse<Box, &setIndex<Box>>>},
                               {"__tostring", &guarded<&inUse<Box, &describe<Box>>>},
                               {"__gc", &guarded<&collectHeld<Box>>},
                               {nullptr, nullptr}};
    registerKind<Box>(lua, methods, events);
}

}  // namespace

PropertyBase& ownPropertyAt(lua_State* lua, int index) { return *ownAt<Property>(lua, index).thing; }
AttributeBase& ownAttributeAt(lua_State* lua, int index) { return *ownAt<Attribute>(lua, index).thing; }

void bindProperty(lua_State* lua) { bind<Property, &makeProperty, &propertyInfo>(lua); }
void bindAttribute(lua_State* lua) { bind<Attribute, &makeAttribute, &attributeInfo>(lua); }

void pushProperty(lua_State* lua, RTT::Service& home, PropertyBase* property) {
    if (!property) throw Failure("'" + home.getName() + "' has no such property");
    pushBox<Property>(lua,
                      Held<PropertyBase>{property, Life(home), home.shared_from_this(), property->getName(), nullptr});
}

void pushAttribute(lua_State* lua, RTT::Service& home, AttributeBase* attribute) {
    if (!attribute) throw Failure("'" + home.getName() + "' has no such attribute");
    pushBox<Attribute>(
        lua, Held<AttributeBase>{attribute, Life(home), home.shared_from_this(), attribute->getName(), nullptr});
}

}  // namespace OCL::lua
