// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OCL_LUA_PUSH_REQUESTER_HPP
#define OCL_LUA_PUSH_REQUESTER_HPP

#include "life.hpp"

#include <rtt/ServiceRequester.hpp>

#include <lua.hpp>

namespace OCL::lua {

/** Pushes the requester that the names from index 2 on lead to, from `requester`. Throws Failure if one does not
    exist. */
int pushRequester(lua_State* lua, RTT::ServiceRequester::shared_ptr requester, const Life& life);

}  // namespace OCL::lua

#endif
