// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OCL_LUA_POOL_FUNCTIONS_HPP
#define OCL_LUA_POOL_FUNCTIONS_HPP

#include <cstddef>

namespace OCL::lua {

class State;

/** The size at first; enough for a component of the usual size with rttlib and rFSM. */
constexpr std::size_t kPoolSize = std::size_t(2) << 20;

/** Adds the table `tlsf`, for a state whose memory is a PoolMemory. */
void addPoolFunctions(State& state);

}  // namespace OCL::lua

#endif
