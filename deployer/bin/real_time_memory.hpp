// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The pool of real-time memory of a program, sized by its option --rtalloc-mem-size.
#ifndef OROFORGE_DEPLOYER_REAL_TIME_MEMORY_HPP
#define OROFORGE_DEPLOYER_REAL_TIME_MEMORY_HPP

#include <cstddef>
#include <string>

namespace OCL::deploy {

/** The bytes that a text like "4096", "512k", "1.5m" or "1g" stands for (1k = 1024); 0 if it is none of these. */
std::size_t parseMemorySize(const std::string& text);

/**
 * Makes a pool of that size, for as long as the process lives, and says on stdout what is free of it. Empty on success,
 * else why there is none.
 */
std::string setRealTimeMemoryAside(std::size_t size);

/** Says on stdout how much of the pool was used at most. */
void reportRealTimeMemory();

/** Keeps what the process has and will have in RAM. Returns why that is not done, with the cure; empty if it is. */
std::string lockMemory();

}  // namespace OCL::deploy

#endif
