// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OCL_LUA_COLLECT_HELD_HPP
#define OCL_LUA_COLLECT_HELD_HPP

#include "box.hpp"
#include "owned_things.hpp"
#include "state.hpp"

namespace OCL::lua {

/** The event __gc of a box of something that Lua code may have made, and that a component may go on using. */
template <class Box>
int collectHeld(lua_State* lua) {
    if (Box* const box = findBox<Box>(lua, 1)) {
        if (box->exists && *box->exists) State::of(lua).owned().forget(box->thing);
        destroyBox<Box>(lua, 1);
    }
    return 0;
}

}  // namespace OCL::lua

#endif
