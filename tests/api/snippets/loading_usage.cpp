// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Loaders and plugins, as programs and tests use them.
#include <rtt/Component.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/internal/GlobalService.hpp>
#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/plugin/ServicePlugin.hpp>

#include <gtest/gtest.h>

namespace loading_usage {

class Echo : public RTT::Service {
public:
    Echo(RTT::TaskContext* owner) : RTT::Service("echo", owner) { addOperation("say", &Echo::say, this); }
    std::string say(std::string what) { return what; }
};

class Small : public RTT::TaskContext {
public:
    Small(std::string const& name) : TaskContext(name) {}
};

}  // namespace loading_usage

ORO_CREATE_COMPONENT(loading_usage::Small)

TEST(UserCode, LoadsComponents) {
    boost::shared_ptr<RTT::ComponentLoader> loader = RTT::ComponentLoader::Instance();
    EXPECT_FALSE(loader->import("no_such_package", ""));
    EXPECT_FALSE(RTT::ComponentLoader::Instance()->isImported("no_such_package"));
    RTT::TaskContext* small = loader->loadComponent("small", "loading_usage::Small");
    ASSERT_TRUE(small);
    EXPECT_EQ(small->getName(), "small");
    EXPECT_EQ(loader->listComponents().size(), 1u);
    EXPECT_TRUE(loader->unloadComponent(small));
    EXPECT_TRUE(loader->loadComponent("other", "no::Such") == 0);
    EXPECT_FALSE(loader->loadLibrary("no/such/library.so"));
}

TEST(UserCode, LoadsPlugins) {
    boost::shared_ptr<RTT::plugin::PluginLoader> loader = RTT::plugin::PluginLoader::Instance();
    EXPECT_FALSE(loader->loadLibrary("no/such/plugin.so"));
    EXPECT_FALSE(loader->isLoaded("no_such_plugin"));
    EXPECT_FALSE(loader->loadTypekits("/no/such/directory"));
    EXPECT_FALSE(RTT::plugin::PluginLoader::Instance()->loadTypekit("none", "/no/such/directory"));
    RTT::TaskContext task("task");
    EXPECT_FALSE(task.loadService("no_such_service"));
    EXPECT_TRUE(task.loadService("marshalling"));
    EXPECT_TRUE(task.provides()->hasService("marshalling"));
    RTT::OperationCaller<bool(const std::string&)> require =
        RTT::internal::GlobalService::Instance()->getOperation("require");
    ASSERT_TRUE(require.ready());
    EXPECT_FALSE(require("no_such_service"));
}

TEST(UserCode, AddsAService) {
    RTT::TaskContext task("task");
    ASSERT_TRUE(task.provides()->addService(RTT::Service::shared_ptr(new loading_usage::Echo(&task))));
    RTT::OperationCaller<std::string(std::string)> say = task.provides("echo")->getOperation("say");
    EXPECT_EQ(say("x"), "x");
    RTT::Service::ProviderNames names = task.provides()->getProviderNames();
    EXPECT_EQ(names.size(), 1u);
    task.provides()->removeService("echo");
    EXPECT_FALSE(task.provides()->hasService("echo"));
    boost::weak_ptr<RTT::Service> weak = task.provides();
    EXPECT_TRUE(weak.lock());
}
