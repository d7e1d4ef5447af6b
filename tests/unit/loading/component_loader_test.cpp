// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "libraries.hpp"

#include <rtt/TaskContext.hpp>

#include <support/temp_dir.hpp>

#include <gmock/gmock.h>

#include <filesystem>
#include <stdexcept>

namespace {

using loading_test::kPath;
using loading_test::kTarget;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

class ComponentLoading : public loading_test::ComponentLoaderTest {};

TEST_F(ComponentLoading, PackageIsFoundBelowTheTargetDirectory) {
    EXPECT_TRUE(import("single"));
    EXPECT_THAT(loader_->listComponentTypes(), Contains("loading_test::Single"));
    EXPECT_TRUE(loader_->isImported("single"));
    EXPECT_TRUE(import("single"));
}

TEST_F(ComponentLoading, LibraryListsItsOwnTypesOnlyNotThoseItLinks) {
    EXPECT_TRUE(import("several"));
    EXPECT_THAT(loader_->listComponentTypes(), Contains("loading_test::First"));
    EXPECT_THAT(loader_->listComponentTypes(), Not(Contains("loading_test::Single")));
}

TEST_F(ComponentLoading, OtherLibrariesBesideComponentsAreNoError) {
    std::string error;
    EXPECT_TRUE(loader_->import("several", std::string(), error)) << error;
}

TEST_F(ComponentLoading, BrokenLibraryIsToldAfterTheOthersHaveBeenLoaded) {
    EXPECT_THROW(import("partly_broken"), std::runtime_error);
    EXPECT_THAT(loader_->listComponentTypes(), Contains("loading_test::Single"));
    EXPECT_FALSE(loader_->isImported("partly_broken"));
    std::string error;
    EXPECT_FALSE(loader_->import("partly_broken", std::string(), error));
    EXPECT_THAT(error, HasSubstr("functionThatNobodyHas"));
}

TEST_F(ComponentLoading, FileAndAbsoluteDirectoryCanBeImported) {
    EXPECT_TRUE(import(kTarget + "/single/libloading_single-" OROCOS_TARGET_NAME ".so"));
    EXPECT_TRUE(import(kTarget + "/several"));
    EXPECT_THAT(loader_->listComponentTypes(), Contains("loading_test::Single"));
    EXPECT_THAT(loader_->listComponentTypes(), Contains("loading_test::First"));
}

TEST_F(ComponentLoading, SourceFolderOfThePackageDoesNotHideTheInstalledOne) {
    const oroforge::test::TempDir workspace;
    workspace.write("single/package.xml", "<package/>");
    const auto old = std::filesystem::current_path();
    std::filesystem::current_path(workspace.path());
    EXPECT_TRUE(import("single"));
    std::filesystem::current_path(old);
    EXPECT_THAT(loader_->listComponentTypes(), Contains("loading_test::Single"));
}

TEST_F(ComponentLoading, FolderWithLibrariesHereGoesFirst) {
    const oroforge::test::TempDir workspace;
    std::filesystem::create_directory_symlink(kTarget + "/several", workspace / "single");
    const auto old = std::filesystem::current_path();
    std::filesystem::current_path(workspace.path());
    EXPECT_TRUE(import("single"));
    std::filesystem::current_path(old);
    EXPECT_THAT(loader_->listComponentTypes(), Contains("loading_test::First"));
    EXPECT_THAT(loader_->listComponentTypes(), Not(Contains("loading_test::Single")));
}

TEST_F(ComponentLoading, UnknownPackageIsAnErrorThatNamesThePath) {
    std::string error;
    EXPECT_FALSE(import("no_such_package"));
    EXPECT_FALSE(import("/no/such/directory"));
    EXPECT_FALSE(loader_->import("no_such_package", std::string(), error));
    EXPECT_THAT(error, HasSubstr(kPath));
}

TEST_F(ComponentLoading, PackageOfWhichThereAreOnlySourcesHereIsToldWithThePath) {
    const oroforge::test::TempDir workspace;
    workspace.write("only_sources/package.xml", "<package/>");
    const auto old = std::filesystem::current_path();
    std::filesystem::current_path(workspace.path());
    std::string error;
    EXPECT_FALSE(loader_->import("only_sources", std::string(), error));
    std::filesystem::current_path(old);
    EXPECT_THAT(error, HasSubstr("no such package or directory in the search path: "));
    EXPECT_THAT(error, HasSubstr(kPath));
    EXPECT_THAT(error, HasSubstr("./only_sources has no components, typekits or plugins"));
}

TEST_F(ComponentLoading, MisspeltPackageIsToldWithTheNearestName) {
    std::string error;
    EXPECT_FALSE(loader_->import("Severl", std::string(), error));
    EXPECT_THAT(error, HasSubstr("; did you mean 'several'?"));
    EXPECT_FALSE(loader_->import("gnulinu", std::string(), error));
    EXPECT_THAT(error, Not(HasSubstr("did you mean")));
}

TEST_F(ComponentLoading, EmptyNameIsAnError) {
    std::string error;
    EXPECT_FALSE(loader_->import("", std::string(), error));
    EXPECT_THAT(error, HasSubstr("empty"));
    EXPECT_FALSE(import(""));
}

TEST_F(ComponentLoading, PathListImportsWhatLiesDirectlyInIt) {
    EXPECT_TRUE(loader_->import(kTarget + "/single;" + kTarget + "/several"));
    EXPECT_THAT(loader_->listComponentTypes(), Contains("loading_test::First"));
    EXPECT_FALSE(loader_->import(kPath + "/nothing"));
}

TEST_F(ComponentLoading, LinkedTypeIsKnownWithoutImport) {
    EXPECT_THAT(loader_->listComponentTypes(), Contains("loading_test::Linked"));
    RTT::TaskContext* component = loader_->loadComponent("own", "loading_test::Linked");
    ASSERT_NE(nullptr, component);
    EXPECT_TRUE(loader_->unloadComponent(component));
}

TEST_F(ComponentLoading, ComponentLivesUntilItIsUnloaded) {
    ASSERT_TRUE(import("single"));
    RTT::TaskContext* component = loader_->loadComponent("one", "loading_test::Single");
    ASSERT_NE(nullptr, component);
    EXPECT_EQ("one", component->getName());
    EXPECT_THAT(loader_->listComponents(), Contains("one"));
    EXPECT_TRUE(loader_->unloadComponent(component));
    EXPECT_THAT(loader_->listComponents(), Not(Contains("one")));
}

TEST_F(ComponentLoading, NameIsTakenAsLongAsTheComponentLives) {
    RTT::TaskContext* first = loader_->loadComponent("same", "loading_test::Linked");
    EXPECT_EQ(nullptr, loader_->loadComponent("same", "loading_test::Linked"));
    loader_->unloadComponent(first);
    RTT::TaskContext* second = loader_->loadComponent("same", "loading_test::Linked");
    EXPECT_NE(nullptr, second);
    loader_->unloadComponent(second);
}

TEST_F(ComponentLoading, ExceptionOfAConstructorIsTold) {
    ASSERT_TRUE(import("several"));
    std::string error;
    EXPECT_EQ(nullptr, loader_->loadComponent("t", "loading_test::Throwing", error));
    EXPECT_EQ("the constructor of component type 'loading_test::Throwing' threw: no hardware at address 7", error);
    // The name is free again.
    RTT::TaskContext* other = loader_->loadComponent("t", "loading_test::First");
    EXPECT_NE(nullptr, other);
    loader_->unloadComponent(other);
}

TEST_F(ComponentLoading, MisspeltTypeIsAnsweredWithTheNearest) {
    ASSERT_TRUE(import("several"));
    std::string error;
    EXPECT_EQ(nullptr, loader_->loadComponent("f", "loading_test::Frist", error));
    EXPECT_THAT(error, HasSubstr("did you mean 'loading_test::First'?"));
    EXPECT_EQ(nullptr, loader_->loadComponent("f", "First", error));
    EXPECT_THAT(error, HasSubstr("did you mean 'loading_test::First'?"));
    EXPECT_EQ(nullptr, loader_->loadComponent("f", "elsewhere::Thing", error));
    EXPECT_EQ("unknown component type 'elsewhere::Thing'; import the package that has it first", error);
}

TEST_F(ComponentLoading, ForeignComponentIsNotDeleted) {
    RTT::TaskContext foreign("foreign");
    EXPECT_FALSE(loader_->unloadComponent(&foreign));
    EXPECT_FALSE(loader_->unloadComponent(nullptr));
}

TEST_F(ComponentLoading, LibraryIsReloadedOnlyWithoutComponents) {
    // A file of its own: other tests leave theirs in memory.
    const oroforge::test::TempDir dir;
    const std::string file = (dir / "libreloaded.so").string();
    std::filesystem::copy_file(kTarget + "/single/libloading_single-" OROCOS_TARGET_NAME ".so", file);
    EXPECT_FALSE(loader_->reloadLibrary(file));
    ASSERT_TRUE(loader_->loadLibrary(file));
    RTT::TaskContext* component = loader_->loadComponent("one", "loading_test::Single");
    EXPECT_FALSE(loader_->reloadLibrary(file));
    loader_->unloadComponent(component);
    EXPECT_TRUE(loader_->reloadLibrary(file));
    EXPECT_THAT(loader_->listComponentTypes(), Contains("loading_test::Single"));
    EXPECT_TRUE(loader_->unloadLibrary(file));
}

TEST_F(ComponentLoading, FactoryCanBeAddedByHand) {
    loader_->addFactory("byhand", [](std::string name) { return new RTT::TaskContext(name); });
    RTT::TaskContext* component = loader_->loadComponent("b", "byhand");
    ASSERT_NE(nullptr, component);
    loader_->unloadComponent(component);
}

}  // namespace
