// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/expect.hpp>

#include <cstdio>
#include <cstdlib>

namespace model {

namespace {
Options effective(Options options) {
    if (const char* stale = std::getenv("MODEL_STALE_READS")) {
        options.staleReads = static_cast<unsigned>(std::atoi(stale));
        options.maxExecutions = 100'000'000;
    }
    return options;
}
}  // namespace

testing::AssertionResult holds(const Scenario& scenario, const Options& options) {
    const Result result = explore(effective(options), scenario);
    testing::Test::RecordProperty("executions", std::to_string(result.executions));
    if (std::getenv("MODEL_VERBOSE")) std::printf("%lu executions\n", result.executions);
    if (result.complete) return testing::AssertionSuccess() << result.executions << " executions";
    if (result.failure.empty())
        return testing::AssertionFailure() << "not exhaustive: gave up after " << result.executions << " executions";
    return testing::AssertionFailure() << result.failure << ", in execution " << result.executions << ":\n"
                                       << result.trace;
}

testing::AssertionResult catches(const char* fault, const Scenario& scenario, const Options& options) {
    plantFault(fault, true);
    const Result result = explore(options, scenario);
    plantFault(fault, false);
    if (std::getenv("MODEL_VERBOSE"))
        std::printf("%s: %s, in execution %lu\n", fault, result.failure.c_str(), result.executions);
    if (!result.failure.empty()) return testing::AssertionSuccess() << result.failure;
    return testing::AssertionFailure() << "the planted fault " << fault << " was not found in " << result.executions
                                       << " executions";
}

}  // namespace model
