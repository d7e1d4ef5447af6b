// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Components find the types and services of the runtime loaded, as in a deployer.
#include <rtt/plugin/PluginLoader.hpp>

#include <gtest/gtest.h>

namespace {

class LoadedRuntime : public testing::Environment {
    void SetUp() override {
        const auto loader = RTT::plugin::PluginLoader::Instance();
        ASSERT_TRUE(loader->loadTypekits(loader->getPluginPath()));
        ASSERT_TRUE(loader->loadPlugins(loader->getPluginPath()));
    }
};

testing::Environment* const loaded = testing::AddGlobalTestEnvironment(new LoadedRuntime);

}  // namespace
