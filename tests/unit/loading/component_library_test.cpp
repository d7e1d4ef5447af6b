// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Component libraries: how they tell their types, how they are unloaded and loaded again.
#include "libraries.hpp"

#include <rtt/TaskContext.hpp>
#include <rtt/base/PortInterface.hpp>

#include <support/temp_dir.hpp>

#include <gmock/gmock.h>

#include <dlfcn.h>

#include <atomic>
#include <filesystem>
#include <thread>

namespace {

using loading_test::fileOf;
using loading_test::isMapped;
using loading_test::kPath;
using loading_test::kTarget;
using oroforge::test::TempDir;
using RTT::ComponentLoader;
using testing::Contains;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

class ComponentLibraries : public loading_test::ComponentLoaderTest {
protected:
    RTT::TaskContext& create(const std::string& name, const std::string& type) {
        RTT::TaskContext* const component = loader_->loadComponent(name, type);
        if (!component) throw std::runtime_error("no component of type " + type);
        return *component;
    }
};

TEST_F(ComponentLibraries, TypesMayBeTemplatesListedInSeveralFiles) {
    ASSERT_TRUE(loader_->import("listed", ""));
    EXPECT_THAT(loader_->listComponentTypes(),
                IsSupersetOf({"loading_test::Pair<int, double>", "loading_test::Pair<char, bool>",
                              "loading_test::Pair<int, int>"}));
    EXPECT_TRUE(loader_->unloadComponent(&create("pair", "loading_test::Pair<int, double>")));
}

TEST_F(ComponentLibraries, LibraryByHandIsLoadedAndUnloadedWithItsConnections) {
    const std::string file = fileOf("byhand", "loading_handwritten");
    ASSERT_TRUE(loader_->loadLibrary(file));
    RTT::TaskContext& one = create("one", "loading_test::Handwritten");
    RTT::TaskContext& two = create("two", "loading_test::Handwritten");
    EXPECT_TRUE(one.getPort("out")->connectTo(two.getPort("in")));
    EXPECT_FALSE(loader_->unloadLibrary(file));
    EXPECT_TRUE(loader_->unloadComponent(&one));
    EXPECT_TRUE(loader_->unloadComponent(&two));
    EXPECT_TRUE(loader_->unloadLibrary(file));
    EXPECT_FALSE(isMapped(file));
    EXPECT_THAT(loader_->listComponentTypes(), Not(Contains("loading_test::Handwritten")));
    EXPECT_FALSE(loader_->unloadLibrary(file));
}

TEST_F(ComponentLibraries, PackageOfAnUnloadedLibraryCanBeImportedAgain) {
    ASSERT_TRUE(loader_->import("listed", ""));
    ASSERT_TRUE(loader_->unloadLibrary(fileOf("listed", "loading_listed")));
    EXPECT_FALSE(loader_->isImported("listed"));
    ASSERT_TRUE(loader_->import("listed", ""));
    EXPECT_THAT(loader_->listComponentTypes(), Contains("loading_test::Pair<int, int>"));
}

TEST_F(ComponentLibraries, ReloadingTakesTheNewFile) {
    const TempDir dir;
    const std::string file = (dir / "libchanging.so").string();
    std::filesystem::copy_file(fileOf("single", "loading_single"), file);
    ASSERT_TRUE(loader_->loadLibrary(file));
    EXPECT_THAT(loader_->listComponentTypes(), Contains("loading_test::Single"));
    std::filesystem::remove(file);
    std::filesystem::copy_file(fileOf("byhand", "loading_handwritten"), file);
    EXPECT_TRUE(loader_->reloadLibrary(file));
    EXPECT_THAT(loader_->listComponentTypes(), Contains("loading_test::Handwritten"));
    EXPECT_THAT(loader_->listComponentTypes(), Not(Contains("loading_test::Single")));
    EXPECT_TRUE(loader_->unloadLibrary(file));
}

TEST_F(ComponentLibraries, ReloadingFailsWhereTheProcessKeepsTheOldFile) {
    const std::string file = fileOf("byhand", "loading_handwritten");
    ASSERT_TRUE(loader_->loadLibrary(file));
    void* const held = dlopen(file.c_str(), RTLD_NOW);
    EXPECT_FALSE(loader_->reloadLibrary(file));
    EXPECT_THAT(loader_->listComponentTypes(), Contains("loading_test::Handwritten"));
    dlclose(held);
    EXPECT_TRUE(loader_->unloadLibrary(file));
}

TEST_F(ComponentLibraries, LibraryMadeWithoutTheDefinitionIsLoadedAsWell) {
    const std::string file = fileOf("unmarked", "loading_unmarked");
    ASSERT_TRUE(loader_->loadLibrary(file));
    RTT::TaskContext& component = create("unmarked", "loading_test::Pair<char, bool>");
    EXPECT_FALSE(loader_->unloadLibrary(file));
    EXPECT_TRUE(loader_->unloadComponent(&component));
    EXPECT_TRUE(loader_->unloadLibrary(file));
    EXPECT_THAT(loader_->listComponentTypes(), Not(Contains("loading_test::Pair<char, bool>")));
}

TEST_F(ComponentLibraries, TypesOfUnmarkedFilesBelongToTheirLibraryAsWell) {
    const std::string file = fileOf("mixed", "loading_mixed");
    ASSERT_TRUE(loader_->loadLibrary(file));
    EXPECT_THAT(loader_->listComponentTypes(), Contains("loading_test::Mixed"));
    RTT::TaskContext& component = create("unmarked", "loading_test::Pair<int, int>");
    EXPECT_FALSE(loader_->unloadLibrary(file));
    ASSERT_TRUE(isMapped(file));
    EXPECT_TRUE(loader_->unloadComponent(&component));
    EXPECT_TRUE(loader_->unloadLibrary(file));
    EXPECT_FALSE(isMapped(file));
}

TEST_F(ComponentLibraries, TypeThatFallsToTheSecondLibraryKeepsThatLoaded) {
    const std::string first = fileOf("unmarked", "loading_unmarked");
    const std::string second = fileOf("unmarked_again", "loading_unmarked_again");
    ASSERT_TRUE(loader_->loadLibrary(first));
    ASSERT_TRUE(loader_->loadLibrary(second));
    EXPECT_TRUE(loader_->unloadLibrary(first));
    EXPECT_FALSE(isMapped(first));
    RTT::TaskContext& component = create("unmarked", "loading_test::Pair<int, int>");
    EXPECT_FALSE(loader_->unloadLibrary(second));
    ASSERT_TRUE(isMapped(second));
    EXPECT_TRUE(loader_->unloadComponent(&component));
    EXPECT_TRUE(loader_->unloadLibrary(second));
    EXPECT_THAT(loader_->listComponentTypes(), Not(Contains("loading_test::Pair<int, int>")));
}

TEST_F(ComponentLibraries, PackageOfALibraryThatCannotBeLoadedAgainIsForgotten) {
    const TempDir dir;
    std::filesystem::create_directory(dir / "package");
    const std::string file = (dir / "package/libgoing.so").string();
    std::filesystem::copy_file(fileOf("byhand", "loading_handwritten"), file);
    const std::string path = dir.path().string();
    ASSERT_TRUE(loader_->import("package", path));
    std::filesystem::rename(file, file + ".old");
    dir.write("package/libgoing.so", "no library");
    EXPECT_FALSE(loader_->reloadLibrary(file));
    EXPECT_FALSE(loader_->isImported("package"));
    std::filesystem::rename(file + ".old", file);
    EXPECT_TRUE(loader_->import("package", path));
    EXPECT_THAT(loader_->listComponentTypes(), Contains("loading_test::Handwritten"));
    EXPECT_TRUE(loader_->unloadLibrary(file));
}

TEST_F(ComponentLibraries, FirstPathWithThePackageWins) {
    const TempDir overlay;
    std::filesystem::create_directory(overlay / OROCOS_TARGET_NAME);
    std::filesystem::create_directory_symlink(kTarget + "/listed", overlay / OROCOS_TARGET_NAME "/single");
    EXPECT_TRUE(loader_->import("single", overlay.path().string() + ";" + kPath));
    EXPECT_THAT(loader_->listComponentTypes(), Contains("loading_test::Pair<int, int>"));
    EXPECT_THAT(loader_->listComponentTypes(), Not(Contains("loading_test::Single")));
}

TEST_F(ComponentLibraries, NothingToImportNamesTheLibrariesThatHoldNoComponents) {
    const TempDir dir;
    std::filesystem::copy_file(fileOf("several", "loading_helper"), dir / "libhelper.so");
    std::string error;
    EXPECT_FALSE(loader_->import(dir.path().string(), "", error));
    EXPECT_THAT(error, HasSubstr("libhelper.so: it exports neither"));
}

TEST_F(ComponentLibraries, LibraryFileInTheCurrentDirectoryIsImportedByItsName) {
    const TempDir dir;
    std::filesystem::copy_file(fileOf("single", "loading_single"), dir / "libhere.so");
    const auto old = std::filesystem::current_path();
    std::filesystem::current_path(dir.path());
    EXPECT_TRUE(loader_->import("libhere.so", ""));
    std::filesystem::current_path(old);
    EXPECT_THAT(loader_->listComponentTypes(), Contains("loading_test::Single"));
}

TEST_F(ComponentLibraries, FactoriesStayAsTheyWereHandedOut) {
    const RTT::FactoryMap& before = loader_->getFactories();
    EXPECT_EQ(&before, &loader_->getFactories());
    ASSERT_EQ(1u, before.count("loading_test::Linked"));
    ASSERT_TRUE(loader_->import("single", ""));
    EXPECT_EQ(0u, before.count("loading_test::Single"));
    EXPECT_EQ(1u, loader_->getFactories().count("loading_test::Single"));
}

TEST_F(ComponentLibraries, ReleaseWaitsForTheLastComponent) {
    const std::string file = fileOf("single", "loading_single");
    ASSERT_TRUE(loader_->loadLibrary(file));
    RTT::TaskContext& component = create("used", "loading_test::Single");
    ComponentLoader::Release();
    EXPECT_EQ(loader_, ComponentLoader::Instance());
    EXPECT_TRUE(loader_->unloadComponent(&component));
    ComponentLoader::Release();
    EXPECT_NE(loader_, ComponentLoader::Instance());
    loader_.reset();
    EXPECT_TRUE(isMapped(file));
}

TEST_F(ComponentLibraries, ComponentIsUnloadedByOneThreadOnly) {
    for (int round = 0; round < 100; ++round) {
        RTT::TaskContext* const component = loader_->loadComponent("shared", "loading_test::Linked");
        ASSERT_NE(nullptr, component);
        std::atomic<int> unloaded{0};
        std::thread other([&] { unloaded += loader_->unloadComponent(component); });
        unloaded += loader_->unloadComponent(component);
        other.join();
        ASSERT_EQ(1, unloaded);
    }
}

}  // namespace
