// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Stack for the compiler, which calls itself for every level of what it reads.
#ifndef OROFORGE_GENERATOR_CLANG_BASE_LARGE_STACK_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_LARGE_STACK_HPP

#include <functional>

namespace oroforge::cxx {

/// Calls `work` and waits for its end, in a thread with as much stack as the system gives, 512 MB at most, of which only what
/// is used takes memory; in this one if there can be no other. Passes exceptions on.
void runOnLargeStack(const std::function<void()>& work);

}  // namespace oroforge::cxx

#endif
