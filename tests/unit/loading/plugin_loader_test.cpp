// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "libraries.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/GlobalService.hpp>
#include <support/temp_dir.hpp>

#include <gmock/gmock.h>

#include <filesystem>

namespace {

using loading_test::kTarget;
using RTT::plugin::PluginLoader;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/** The path of a test library in a package's plugins directory. */
std::string plugin(const std::string& package, const std::string& name) {
    return loading_test::fileOf(package + "/plugins", name);
}

class PluginLoading : public loading_test::PluginLoaderTest {};

TEST_F(PluginLoading, DirectoryOfPluginsIsLoaded) {
    EXPECT_TRUE(loader_->loadPlugins(kTarget + "/services"));
    EXPECT_THAT(loader_->listServices(), Contains("counting"));
    EXPECT_THAT(loader_->listPlugins(), Contains("counting"));
    EXPECT_THAT(loader_->listTypekits(), IsEmpty());
}

TEST_F(PluginLoading, LoadedPluginIsKnownByFilePluginAndShortName) {
    ASSERT_TRUE(loader_->loadLibrary(plugin("services", "loading_service")));
    EXPECT_TRUE(loader_->isLoaded("counting"));
    EXPECT_TRUE(loader_->isLoaded("loading_service"));
    EXPECT_TRUE(loader_->isLoaded(plugin("services", "loading_service")));
    EXPECT_FALSE(loader_->isLoaded("loading"));
    EXPECT_TRUE(loader_->loadLibrary(plugin("services", "loading_service")));
    EXPECT_EQ(1u, loader_->listServices().size());
}

TEST_F(PluginLoading, PluginIsFoundByName) {
    EXPECT_TRUE(loader_->loadPlugin("loading_service", kTarget + "/services"));
    EXPECT_FALSE(loader_->loadPlugin("no_such_plugin", kTarget + "/services"));
}

TEST_F(PluginLoading, PackageOfThatNameIsLoadedAsAWhole) {
    EXPECT_TRUE(loader_->loadPlugin("services", loading_test::kPath)) << "in the directory of the target below it";
    EXPECT_THAT(loader_->listServices(), testing::IsSupersetOf({"counting", "globalcounting"}));
    EXPECT_TRUE(loader_->loadPlugin("services", kTarget)) << "all of it is loaded already";
    EXPECT_FALSE(loader_->loadPlugin("", kTarget));
    EXPECT_FALSE(loader_->loadPlugin("no_such_package", kTarget));
    EXPECT_FALSE(loader_->loadPlugin("odd", kTarget)) << "some of it refuse";
}

TEST_F(PluginLoading, PackageHasTypekitsAndPlugins) {
    const oroforge::test::TempDir directory;
    const std::filesystem::path package = directory / "robot";
    for (const char* kind : {"types", "plugins"}) std::filesystem::create_directories(package / kind);
    std::filesystem::copy(plugin("services", "loading_service"), package / "plugins");
    std::filesystem::copy(plugin("services", "loading_global_service"), package / "types");
    EXPECT_TRUE(loader_->loadTypekit("robot", "/nowhere:" + directory.path().string()));
    EXPECT_THAT(loader_->listTypekits(), Contains("globalcounting"));
    EXPECT_THAT(loader_->listPlugins(), Contains("counting"));
    loader_->setPluginPath(directory.path().string());
    EXPECT_TRUE(loader_->loadPlugin("robot"));
}

TEST_F(PluginLoading, PackageIsLoadedThoughAPluginHasItsName) {
    const oroforge::test::TempDir directory;
    const std::filesystem::path types = directory / OROCOS_TARGET_NAME "/loading_service/types";
    std::filesystem::create_directories(types);
    std::filesystem::copy(plugin("services", "loading_global_service"), types);
    ASSERT_TRUE(loader_->loadLibrary(plugin("services", "loading_service")));
    EXPECT_TRUE(loader_->loadTypekit("loading_service", directory.path().string()));
    EXPECT_THAT(loader_->listTypekits(), Contains("globalcounting"));
}

TEST_F(PluginLoading, ServiceIsAddedToEachComponentThatAsks) {
    ASSERT_TRUE(loader_->loadPlugins(kTarget + "/services"));
    RTT::TaskContext one("one");
    RTT::TaskContext two("two");
    EXPECT_TRUE(loader_->loadService("counting", &one));
    EXPECT_TRUE(loader_->loadService("counting", &two));
    ASSERT_TRUE(one.provides()->hasService("counting"));
    RTT::OperationCaller<int()> next(one.provides()->getService("counting")->getOperation("next"));
    EXPECT_EQ(1, next());
    EXPECT_EQ(2, next());
}

TEST_F(PluginLoading, ComponentLoadsServicesThroughTheLoader) {
    ASSERT_TRUE(loader_->loadPlugins(kTarget + "/services"));
    RTT::TaskContext component("component");
    EXPECT_TRUE(component.loadService("counting"));
    EXPECT_TRUE(component.provides()->hasService("counting"));
    EXPECT_FALSE(component.loadService("no_such_service"));
}

TEST_F(PluginLoading, ServiceThatThrowsIsNotLoaded) {
    ASSERT_TRUE(loader_->loadPlugins(kTarget + "/services"));
    RTT::TaskContext unlucky("unlucky");
    EXPECT_FALSE(loader_->loadService("counting", &unlucky));
    EXPECT_FALSE(loader_->loadService("no_such_service", &unlucky));
}

TEST_F(PluginLoading, GlobalServiceIsThereAfterLoading) {
    ASSERT_TRUE(loader_->loadPlugins(kTarget + "/services"));
    EXPECT_TRUE(RTT::internal::GlobalService::Instance()->hasService("globalcounting"));
    RTT::TaskContext component("component");
    EXPECT_FALSE(loader_->loadService("globalcounting", &component));
}

TEST_F(PluginLoading, ReasonsOfRefusalAreTold) {
    EXPECT_EQ("plugin 'odd1' refused to load into this process", errorOf(plugin("odd", "loading_refusing")));
    EXPECT_EQ("plugin 'odd2' threw while loading: no licence for this robot",
              errorOf(plugin("odd", "loading_throwing")));
    EXPECT_EQ("plugin 'odd3' is built for target xenomai, this program for " OROCOS_TARGET_NAME,
              errorOf(plugin("odd", "loading_other_target")));
    EXPECT_EQ("not a plugin, it does not export loadRTTPlugin", errorOf(plugin("odd", "loading_no_plugin")));
    EXPECT_THAT(errorOf(plugin("odd", "no_such_file")), HasSubstr("cannot open shared object file"));
}

TEST_F(PluginLoading, LibraryOfWhichAPartIsMissingIsRefused) {
    const std::string whole = plugin("services", "loading_service");
    const std::string part = plugin("cut_short", "loading_part");
    std::filesystem::create_directories(std::filesystem::path(part).parent_path());
    for (const int left : {5000, 4096, 100}) {  // fewer than its code and data have
        std::filesystem::copy_file(whole, part, std::filesystem::copy_options::overwrite_existing);
        std::filesystem::resize_file(part, left);
        EXPECT_THAT(errorOf(part), HasSubstr("cut short: it has " + std::to_string(left) + " bytes, expected "));
    }
    std::filesystem::resize_file(part, 10);
    EXPECT_THAT(errorOf(part), HasSubstr("file too short"));
    oroforge::test::writeFile(part, "!<arch>\n");
    EXPECT_EQ("it is a static library, which can only be linked into a program", errorOf(part));
}

TEST_F(PluginLoading, LibraryOutsideOfPluginsAndTypesIsRefused) {
    EXPECT_EQ("its directory is named 'single', expected 'types' or 'plugins'",
              errorOf(kTarget + "/single/libloading_single-" OROCOS_TARGET_NAME ".so"));
}

TEST_F(PluginLoading, FailuresInADirectoryDoNotThrowAndAreReported) {
    EXPECT_FALSE(loader_->loadPlugins(kTarget + "/odd"));
    const PluginLoader::Scan scan = loader_->importDirectory(kTarget + "/odd");
    EXPECT_EQ(5u, scan.found);
    EXPECT_EQ(5u, scan.errors.size());
}

TEST_F(PluginLoading, InstalledTypekitIsOnTheDefaultPath) {
    EXPECT_THAT(loader_->getPluginPath(), HasSubstr("/orocos"));
    loader_->setPluginPath("/elsewhere");
    EXPECT_EQ("/elsewhere", loader_->getPluginPath());
}

}  // namespace
