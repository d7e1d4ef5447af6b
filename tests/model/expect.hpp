// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What tests say of scenarios. With MODEL_VERBOSE in the environment they print the number of executions and what the
// planted faults led to. MODEL_STALE_READS=<n> sets Options::staleReads for all, which may take long.
#ifndef OROFORGE_MODEL_EXPECT_HPP
#define OROFORGE_MODEL_EXPECT_HPP

#include <model/checker/checker.hpp>

#include <gtest/gtest.h>

namespace model {

typedef std::function<void(Trial&)> Scenario;

/** Success if no order of steps fails, and all were tried. */
testing::AssertionResult holds(const Scenario& scenario, const Options& options = Options());

/** Success if some order fails while the fault is planted. That none does without it, holds() says. */
testing::AssertionResult catches(const char* fault, const Scenario& scenario, const Options& options = Options());

}  // namespace model

#endif
