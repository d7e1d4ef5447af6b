// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The component goldens, compiled, are loaded as the deployer would, and run.
#include <string>

#include <gtest/gtest.h>
#include <rtt/Property.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/internal/ComponentDescription.hpp>
#include <rtt/types/TypeOps.hpp>

namespace {

struct Case {
    const char* library;
    const char* type;
};

class GoldenComponent : public testing::TestWithParam<Case> {};

TEST_P(GoldenComponent, IsLoadedAndRuns) {
    const auto loader = RTT::ComponentLoader::Instance();
    const std::string file =
        std::string(GOLDEN_COMPONENTS "/libgolden-") + GetParam().library + "-" TARGET_SUFFIX ".so";
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

const RTT::internal::ComponentDescription* descriptionOf(const std::string& type) {
    const RTT::FactoryMap& factories = RTT::ComponentLoader::Instance()->getFactories();
    const auto create = factories.find(type);
    return create == factories.end()
               ? nullptr
               : RTT::internal::ComponentDescriptions::find(type, reinterpret_cast<const void*>(create->second));
}

TEST(GoldenDescription, ComesAndGoesWithItsLibrary) {
    const auto loader = RTT::ComponentLoader::Instance();
    const std::string file = GOLDEN_COMPONENTS "/libgolden-services-" TARGET_SUFFIX ".so";
    ASSERT_TRUE(loader->loadLibrary(file));
    const auto* client = descriptionOf("services::Client");
    ASSERT_NE(client, nullptr);
    EXPECT_STREQ(client->package, "services");

    // Of another library with such a type nothing is known.
    const auto somewhereElse = reinterpret_cast<const void*>(&RTT::internal::ComponentDescriptions::find);
    EXPECT_EQ(RTT::internal::ComponentDescriptions::find("services::Client", somewhereElse), nullptr);

    const auto create = reinterpret_cast<const void*>(loader->getFactories().at("services::Client"));
    ASSERT_TRUE(loader->unloadLibrary(file));
    EXPECT_EQ(RTT::internal::ComponentDescriptions::find("services::Client", create), nullptr);
    ASSERT_TRUE(loader->loadLibrary(file));
    EXPECT_NE(descriptionOf("services::Client"), nullptr);
}

TEST(GoldenDescription, HasWhatTheComponentHas) {
    const auto loader = RTT::ComponentLoader::Instance();
    for (const char* library : {"tank", "services", "value_types"})
        ASSERT_TRUE(
            loader->loadLibrary(GOLDEN_COMPONENTS "/libgolden-" + std::string(library) + "-" TARGET_SUFFIX ".so"));
    for (const char* type : {"tank::Controller", "services::Client", "values::All"}) {
        const auto* description = descriptionOf(type);
        ASSERT_NE(description, nullptr) << type;
        RTT::TaskContext* component = loader->loadComponent("described", type);
        ASSERT_NE(component, nullptr) << type;
        std::size_t ports = 0, properties = 0;
        for (const auto& port : description->ports) {
            if (std::string(port.name).find('.') != std::string::npos) continue;
            ++ports;
            RTT::base::PortInterface* real = component->getPort(port.name);
            ASSERT_NE(real, nullptr) << port.name;
            EXPECT_STREQ(real->sampleOps()->id->name(), port.type->name()) << port.name;
            EXPECT_EQ(dynamic_cast<RTT::base::OutputPortInterface*>(real) != nullptr, port.output) << port.name;
        }
        for (const auto& property : description->properties) {
            if (std::string(property.name).find('.') != std::string::npos) continue;
            ++properties;
            EXPECT_NE(component->getProperty(property.name), nullptr) << property.name;
        }
        EXPECT_EQ(ports, component->ports()->getPorts().size()) << type;
        EXPECT_EQ(properties, component->properties()->size()) << type;
        loader->unloadComponent(component);
    }
}

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
