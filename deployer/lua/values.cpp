// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "values.hpp"

#include "box.hpp"
#include "conversion.hpp"
#include "state.hpp"
#include "things.hpp"

#include <rtt/base/ActionInterface.hpp>
#include <rtt/internal/DataSource.hpp>
#include <rtt/types/TypeInfoRepository.hpp>

#include <memory>

namespace OCL::lua {

using RTT::base::DataSourceBase;

void pushValue(lua_State* lua, const DataSourceBase::shared_ptr& source, const Life& life) {
    if (!source) return lua_pushnil(lua);
    const Conversion& conversion = State::of(lua).conversion(source->getTypeInfo());
    if (!conversion.isBasic()) {
        pushBox<Variable>(lua, source, life);
        return;
    }
    if (!conversion.isVoid() && !source->evaluate())
        throw Failure("a value of type " + conversion.typeName() + " cannot be read");
    conversion.push(lua, conversion.isVoid() ? nullptr : source->getRawConstPointer());
}

void pushCopy(lua_State* lua, const Conversion& conversion, DataSourceBase& source) {
    if (conversion.isBasic()) return conversion.push(lua, conversion.isVoid() ? nullptr : source.getRawConstPointer());
    const DataSourceBase::shared_ptr copy = conversion.type() ? conversion.type()->buildValue() : nullptr;
    // Evaluating the source again would call the operation again.
    const void* const value = source.getRawConstPointer();
    if (!copy || !value || !copy->assignValue(value)) return lua_pushnil(lua);
    pushBox<Variable>(lua, copy, Life());
}

const RTT::types::TypeInfo* findType(const std::string& name) {
    const auto types = RTT::types::Types();
    if (const RTT::types::TypeInfo* const known = types->type(name)) return known;
    // Other names of numbers; a typekit may have types of these names.
    if (name == "int32") return types->getTypeInfo<std::int32_t>();
    if (name == "uint32") return types->getTypeInfo<std::uint32_t>();
    if (name == "long") return types->getTypeInfo<long>();
    if (name == "ulong") return types->getTypeInfo<unsigned long>();
    return nullptr;
}

const RTT::types::TypeInfo& typeNamed(const std::string& name) {
    const RTT::types::TypeInfo* const type = findType(name);
    if (!type) throw Failure("no typekit that is loaded has a type '" + name + "'; import the package that has it");
    if (type == RTT::internal::DataSource<void>::GetTypeInfo()) throw Failure("there are no values of type void");
    return *type;
}

DataSourceBase::shared_ptr newValue(const std::string& type) {
    const DataSourceBase::shared_ptr made = typeNamed(type).buildValue();
    if (!made) throw Failure("type '" + type + "' has no default value");
    return made;
}

void assign(lua_State* lua, int index, DataSourceBase& target) {
    Variable* const variable = findBox<Variable>(lua, index);
    if (!variable) return State::of(lua).conversion(target.getTypeInfo()).assign(lua, index, target);
    variable->life.check(Variable::kName);
    if (!variable->source->evaluate()) throw Failure("the value on the right cannot be read");
    if (target.update(variable->source.get())) return target.updated();
    std::unique_ptr<RTT::base::ActionInterface> action;
    try {
        action.reset(target.updateAction(variable->source.get()));
    } catch (const RTT::base::bad_assignment&) {
    }
    if (!action)
        throw Failure("a " + variable->source->getTypeName() + " cannot be assigned to a " + target.getTypeName());
    action->readArguments();
    if (!action->execute())
        throw Failure("a " + variable->source->getTypeName() + " could not be assigned to a " + target.getTypeName());
    target.updated();
}

std::string textAt(lua_State* lua, int index) {
    std::size_t size = 0;
    const char* const text = lua_isstring(lua, index) ? lua_tolstring(lua, index, &size) : nullptr;
    if (!text) detail::wrongKind(lua, index, "string");
    return std::string(text, size);
}

std::string textAt(lua_State* lua, int index, const std::string& otherwise) {
    return lua_isnoneornil(lua, index) ? otherwise : textAt(lua, index);
}

void pushText(lua_State* lua, const std::string& text) { lua_pushlstring(lua, text.data(), text.size()); }

void pushTexts(lua_State* lua, const std::vector<std::string>& texts) {
    lua_createtable(lua, static_cast<int>(texts.size()), 0);
    int index = 0;
    for (const std::string& text : texts) {
        pushText(lua, text);
        lua_rawseti(lua, -2, ++index);
    }
}

void setField(lua_State* lua, const char* name, const std::string& value) {
    pushText(lua, value);
    lua_setfield(lua, -2, name);
}

}  // namespace OCL::lua
