// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The pool of real-time memory of a program, whose option --rtalloc-mem-size gives the size.
#ifndef OROFORGE_DEPLOYER_REAL_TIME_MEMORY_HPP
#define OROFORGE_DEPLOYER_REAL_TIME_MEMORY_HPP

#include <cstddef>
#include <string>

namespace OCL::deploy {

/** The bytes in a text such as "4096", "512k", "1.5m" or "1g" (1k = 1024); 0 if it is malformed. */
std::size_t parseMemorySize(const std::string& text);

/**
 * Makes a pool of that size for the life of the process, and prints to stdout how much of it is free. Empty on success,
 * otherwise the reason of the failure.
 */
std::string setRealTimeMemoryAside(std::size_t size);

/** Says on stdout how much of the pool was used at most. */
void reportRealTimeMemory();

/** Keeps what the process has and will have in RAM. Returns why that is not done, with the cure; empty if it is. */
std::string lockMemory();

}  // namespace OCL::deploy

#endif
