// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Completes a line of Lua code that is being typed.
#ifndef OCL_LUA_COMPLETE_HPP
#define OCL_LUA_COMPLETE_HPP

#include "state.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace OCL::lua {

struct Completed {
    std::size_t begin = 0;           ///< where in the line the words go
    std::vector<std::string> words;  ///< in alphabetical order
    std::string behind;              ///< what follows if there is only one word
};

/**
 * The words that begin with the end of the line: globals and keywords; fields of tables; methods, operations and
 * members of what C++ has; within quotes the names that the function in front of them takes. Calls no Lua code.
 * Waits for other threads to leave the state.
 */
Completed complete(State& state, const std::string& line);

}  // namespace OCL::lua

#endif
