// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Provides stack for the compiler, which recurses for every level of nesting.
#ifndef OROFORGE_GENERATOR_CLANG_BASE_LARGE_STACK_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_LARGE_STACK_HPP

#include <functional>

namespace oroforge::cxx {

/// Calls `work` in a thread with a stack of up to 512 MB and waits for its end; only used stack takes memory. Calls it
/// in this thread if there can be no other. Passes exceptions on.
void runOnLargeStack(const std::function<void()>& work);

}  // namespace oroforge::cxx

#endif
