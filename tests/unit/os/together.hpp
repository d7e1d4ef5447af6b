// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_UNIT_OS_TOGETHER_HPP
#define OROFORGE_TESTS_UNIT_OS_TOGETHER_HPP

#include <functional>
#include <thread>
#include <vector>

namespace oroforge::test {

/** More than a small machine has processors, so that threads are interrupted at any place. */
constexpr int kThreads = 4;

/** Executes f(0) to f(kThreads - 1) in a thread each and returns when all have ended. */
inline void together(const std::function<void(int)>& f) {
    std::vector<std::thread> threads;
    for (int t = 0; t < kThreads; ++t) threads.emplace_back([&, t] { f(t); });
    for (auto& t : threads) t.join();
}

}  // namespace oroforge::test
#endif
