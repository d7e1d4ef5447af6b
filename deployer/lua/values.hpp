// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OCL_LUA_VALUES_HPP
#define OCL_LUA_VALUES_HPP

#include "life.hpp"

#include <rtt/base/DataSourceBase.hpp>

#include <lua.hpp>

#include <string>
#include <vector>

namespace RTT::types {
class TypeInfo;
}

namespace OCL::lua {

class Conversion;

/** Evaluates `source` and pushes its value: basic types become values of Lua, others a Variable that shares the
    value. */
void pushValue(lua_State* lua, const RTT::base::DataSourceBase::shared_ptr& source, const Life& life);
/** Pushes a copy of the value that `source` had at its last evaluation. */
void pushCopy(lua_State* lua, const Conversion& conversion, RTT::base::DataSourceBase& source);
/** A new value of the type that the text at `index` names. Throws Failure. */
RTT::base::DataSourceBase::shared_ptr newValue(const std::string& type);
/** Null if there is no such type. */
const RTT::types::TypeInfo* findType(const std::string& name);
/** Throws Failure if there is no such type, or it has no values. */
const RTT::types::TypeInfo& typeNamed(const std::string& name);

/** The argument at `index`. Throws Failure if it is no text. */
std::string textAt(lua_State* lua, int index);
/** The same, or the default if there is no such argument. */
std::string textAt(lua_State* lua, int index, const std::string& otherwise);

void pushText(lua_State* lua, const std::string& text);
void pushTexts(lua_State* lua, const std::vector<std::string>& texts);
/** Sets a field of the table on top. */
void setField(lua_State* lua, const char* name, const std::string& value);

}  // namespace OCL::lua

#endif
