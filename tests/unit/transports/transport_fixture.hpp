// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What tests of transports share.
#ifndef OROFORGE_TESTS_TRANSPORT_FIXTURE_HPP
#define OROFORGE_TESTS_TRANSPORT_FIXTURE_HPP

#include <rtt/Port.hpp>
#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/types/Types.hpp>

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>

#include <unistd.h>

namespace transport_test {

/// True as soon as `condition()` is, false after 20 s.
template <class Condition>
bool soon(Condition condition) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (!condition()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
}

/// Reads the next sample, which may take a while.
template <class T>
bool readSoon(RTT::InputPort<T>& port, T& sample) {
    return soon([&] { return port.read(sample, false) == RTT::NewData; });
}

/// A name that no other process uses.
inline std::string queueName(const std::string& name) { return "/oroforge_" + std::to_string(getpid()) + "_" + name; }

class WithTypes : public testing::Test {
protected:
    static void SetUpTestSuite() {
        EXPECT_TRUE(RTT::types::Types()->type("double") ||
                    RTT::plugin::PluginLoader::Instance()->loadTypekit("rtt-typekit"));
    }
};

}  // namespace transport_test

#endif
