// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The component goldens, compiled, are loaded as the deployer would, and run.
#include <string>

#include <gtest/gtest.h>
#include <rtt/Property.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/deployment/ComponentLoader.hpp>

namespace {

struct Case {
    const char* library;
    const char* type;
};

class GoldenComponent : public testing::TestWithParam<Case> {};

TEST_P(GoldenComponent, IsLoadedAndRuns) {
    const auto loader = RTT::ComponentLoader::Instance();
    const std::string file = std::string(GOLDEN_COMPONENTS "/libgolden-") + GetParam().library + "-" TARGET_SUFFIX ".so";
    ASSERT_TRUE(loader->loadLibrary(file));
    ASSERT_TRUE(loader->isImported(GetParam().type));

    RTT::TaskContext* component = loader->loadComponent("golden", GetParam().type);

    ASSERT_NE(component, nullptr);
    EXPECT_TRUE(component->configure());
    EXPECT_TRUE(component->start());
    EXPECT_TRUE(component->stop());
    EXPECT_TRUE(loader->unloadComponent(component));
}

INSTANTIATE_TEST_SUITE_P(Golden, GoldenComponent,
                         testing::Values(Case{"tank", "tank::Controller"}, Case{"two_components", "pair::Source"},
                                         Case{"two_components", "pair::Sink"}, Case{"global_namespace", "Plain"},
                                         Case{"value_types", "values::All"}, Case{"activities", "acts::Slave"},
                                         Case{"activities", "acts::Sequential"}, Case{"activities", "acts::Event"},
                                         Case{"services", "services::Client"}));

TEST(GoldenRange, KeepsAComponentFromConfiguring) {
    const auto loader = RTT::ComponentLoader::Instance();
    ASSERT_TRUE(loader->loadLibrary(GOLDEN_COMPONENTS "/libgolden-tank-" TARGET_SUFFIX ".so"));
    RTT::TaskContext* component = loader->loadComponent("controller", "tank::Controller");
    ASSERT_NE(component, nullptr);
    auto* gain = dynamic_cast<RTT::Property<double>*>(component->getProperty("gain"));
    ASSERT_NE(gain, nullptr);

    gain->set(-1.0);
    EXPECT_FALSE(component->configure());
    EXPECT_EQ(component->getTaskState(), RTT::TaskContext::PreOperational);
    gain->set(0.0);
    EXPECT_TRUE(component->configure());

    loader->unloadComponent(component);
}

}  // namespace
