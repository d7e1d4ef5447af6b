// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OCL_LUA_ASSIGN_TABLE_HPP
#define OCL_LUA_ASSIGN_TABLE_HPP

#include <rtt/base/DataSourceBase.hpp>
#include <rtt/types/Shape.hpp>

#include <lua.hpp>

namespace OCL::lua {

/** Assigns the table at `index`: names are members; indices from 1 on are the elements of a sequence, which gets as
    many as the table has. Throws Failure. */
void assignTable(lua_State* lua, int index, RTT::base::DataSourceBase& target, const RTT::types::Shape& shape);

}  // namespace OCL::lua

#endif
