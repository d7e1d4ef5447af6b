// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "member_access.hpp"

#include "conversion.hpp"
#include "state.hpp"
#include "values.hpp"

#include <rtt/internal/DataSources.hpp>

#include <cctype>

namespace OCL::lua {

typedef RTT::base::DataSourceBase::shared_ptr Source;

namespace {

/** False if the key is no index. */
bool readIndex(lua_State* lua, int index, lua_Number& read) {
    if (lua_type(lua, index) == LUA_TSTRING && !std::isdigit(static_cast<unsigned char>(*lua_tostring(lua, index))))
        return false;
    if (!lua_isnumber(lua, index)) return false;
    read = lua_tonumber(lua, index);
    return true;
}

Source elementAt(lua_State* lua, const Source& whole, lua_Number index) {
    if (!(index >= 0 && index < 2147483648.0)) return nullptr;
    // Elements behind the last one would be values of nothing.
    if (!State::of(lua).conversion(whole->getTypeInfo()).hasElement(*whole, static_cast<std::size_t>(index)))
        return nullptr;
    const Source id(new RTT::internal::ConstantDataSource<int>(static_cast<int>(index)));
    return whole->getMember(id);
}

}  // namespace

Source memberAt(lua_State* lua, int index, const Source& whole) {
    lua_Number number = 0;
    const Source found =
        readIndex(lua, index, number) ? elementAt(lua, whole, number) : whole->getMember(textAt(lua, index));
    if (found) return found;
    // On the copy: a number as key must stay one.
    lua_pushvalue(lua, index);
    throw Failure("type " + whole->getTypeName() + " has no member '" + textAt(lua, -1) + "'");
}

}  // namespace OCL::lua
