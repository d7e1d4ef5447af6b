// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OCL_LUA_MEMBER_ACCESS_HPP
#define OCL_LUA_MEMBER_ACCESS_HPP

#include <rtt/base/DataSourceBase.hpp>

#include <lua.hpp>

namespace OCL::lua {

/** The part of a value that the key at `index` names: a member, or an element, counted from 0. Throws Failure if there
    is none. */
RTT::base::DataSourceBase::shared_ptr memberAt(lua_State* lua, int index,
                                               const RTT::base::DataSourceBase::shared_ptr& whole);

}  // namespace OCL::lua

#endif
