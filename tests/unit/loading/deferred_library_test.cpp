// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// importInstalled() loads a component library when one of its types is needed.
#include "libraries.hpp"

#include <rtt/TaskContext.hpp>
#include <rtt/deployment/detail/listed_types.hpp>

#include <support/temp_dir.hpp>

#include <gmock/gmock.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>
#include <vector>

namespace {

using loading_test::fileOf;
using loading_test::isMapped;
using oroforge::test::TempDir;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;

/** Has copies of the test libraries, which no other test has loaded. */
class DeferredLibraries : public loading_test::ComponentLoaderTest {
protected:
    DeferredLibraries() { loader_->setComponentPath(place_.path().string()); }

    std::string add(const std::string& package, const std::string& from, const std::string& library) {
        const std::string folder = place_ / package;
        std::filesystem::create_directories(folder);
        const std::string file = folder + "/lib" + library + "-" OROCOS_TARGET_NAME ".so";
        std::filesystem::copy_file(fileOf(from, library), file);
        return std::filesystem::canonical(file);
    }
    bool importInstalled(const std::string& package) {
        std::string error;
        const bool done = loader_->importInstalled(package, error);
        EXPECT_THAT(error, IsEmpty());
        return done;
    }
    std::string errorOf(const std::string& type) {
        std::string error;
        EXPECT_EQ(loader_->loadComponent("component", type, error), nullptr);
        return error;
    }
    void expectCreated(const std::string& type) {
        std::string error;
        RTT::TaskContext* const component = loader_->loadComponent("component", type, error);
        ASSERT_NE(component, nullptr) << error;
        EXPECT_TRUE(loader_->unloadComponent(component));
    }
    /** Makes it one for another machine, which the linker refuses. */
    static void damage(const std::string& file) {
        std::string bytes = oroforge::test::readFile(file);
        bytes[18] = 0x7f;
        oroforge::test::writeFile(file, bytes);
    }

    const TempDir place_;
};

TEST_F(DeferredLibraries, TypesAreKnownBeforeTheirLibraryIsLoaded) {
    const std::string file = add("lazy", "listed", "loading_listed");
    ASSERT_TRUE(importInstalled("lazy"));
    EXPECT_TRUE(loader_->isImported("lazy"));
    EXPECT_TRUE(loader_->isImported("loading_test::Pair<int, int>"));
    EXPECT_FALSE(isMapped(file));
    EXPECT_THAT(loader_->listComponentTypes(),
                IsSupersetOf({"loading_test::Pair<int, double>", "loading_test::Pair<char, bool>",
                              "loading_test::Pair<int, int>"}));
    EXPECT_TRUE(isMapped(file));
}

TEST_F(DeferredLibraries, UnknownTypesAreLookedForInAll) {
    add("lazy", "listed", "loading_listed");
    const std::string mixed = add("lazy", "mixed", "loading_mixed");
    ASSERT_TRUE(importInstalled("lazy"));
    expectCreated("loading_test::Mixed");
    expectCreated("loading_test::Pair<int, int>");
    EXPECT_THAT(errorOf("loading_test::Pear<int, int>"), HasSubstr("did you mean 'loading_test::Pair<int, int>'"));
    EXPECT_TRUE(loader_->unloadLibrary(mixed));  // registers types for all loaders
}

TEST_F(DeferredLibraries, TypesThatItsFileDoesNotListAreFound) {
    const std::string file = add("lazy", "mixed", "loading_mixed");  // lists one of three
    ASSERT_TRUE(importInstalled("lazy"));
    EXPECT_FALSE(isMapped(file));
    EXPECT_NE(loader_->factoryOf("loading_test::Pair<int, int>"), nullptr);
    EXPECT_TRUE(loader_->unloadLibrary(file));
}

TEST_F(DeferredLibraries, OnlyTheLibraryOfTheTypeIsLoaded) {
    const std::string wanted = add("lazy", "listed", "loading_listed"), other = add("lazy", "single", "loading_single");
    ASSERT_TRUE(importInstalled("lazy"));
    expectCreated("loading_test::Pair<char, bool>");
    EXPECT_TRUE(isMapped(wanted));
    EXPECT_FALSE(isMapped(other));
    EXPECT_NE(loader_->factoryOf("loading_test::Single"), nullptr);
    EXPECT_TRUE(isMapped(other));
    EXPECT_EQ(loader_->factoryOf("loading_test::Unknown"), nullptr);
}

TEST_F(DeferredLibraries, FactoriesAreThoseOfAllLibraries) {
    const std::string file = add("lazy", "listed", "loading_listed");
    ASSERT_TRUE(importInstalled("lazy"));
    EXPECT_EQ(loader_->getFactories().count("loading_test::Pair<int, int>"), 1u);
    EXPECT_TRUE(isMapped(file));
}

TEST_F(DeferredLibraries, ImportLoadsAllOfThePackage) {
    const std::string file = add("lazy", "listed", "loading_listed");
    ASSERT_TRUE(importInstalled("lazy"));
    ASSERT_TRUE(import("lazy"));
    EXPECT_TRUE(isMapped(file));
    expectCreated("loading_test::Pair<int, double>");
}

TEST_F(DeferredLibraries, LibraryThatCannotBeLoadedIsTheReasonAndHidesNoOther) {
    damage(add("lazy", "single", "loading_single"));
    add("lazy", "listed", "loading_listed");
    ASSERT_TRUE(importInstalled("lazy"));
    EXPECT_THAT(errorOf("loading_test::Single"),
                AllOf(HasSubstr("the library of component type 'loading_test::Single' cannot be loaded: "),
                      HasSubstr("loading_single")));
    expectCreated("loading_test::Pair<int, double>");
    EXPECT_EQ(loader_->getFactories().count("loading_test::Single"), 0u);
    std::string error;
    for (int attempt = 0; attempt < 2; ++attempt) {
        EXPECT_FALSE(loader_->import("lazy", std::string(), error));
        EXPECT_THAT(error, HasSubstr("loading_single"));
    }
}

TEST_F(DeferredLibraries, FirstLibraryWithATypeHasItThoughItWaits) {
    const std::string first = add("lazy", "single", "loading_single"),
                      second = add("other", "single", "loading_single");
    ASSERT_TRUE(importInstalled("lazy"));
    ASSERT_TRUE(loader_->loadLibrary(second));
    EXPECT_THAT(loader_->listComponentTypes(first), Contains("loading_test::Single"));
    EXPECT_THAT(loader_->listComponentTypes(second), IsEmpty());
}

TEST_F(DeferredLibraries, TwoThatWaitAndHaveTheSameTypeGoInTheirOrder) {
    const std::string first = add("lazy", "single", "loading_single"),
                      second = add("other", "single", "loading_single");
    ASSERT_TRUE(importInstalled("lazy"));
    ASSERT_TRUE(importInstalled("other"));
    ASSERT_TRUE(import("other"));
    EXPECT_THAT(loader_->listComponentTypes(first), Contains("loading_test::Single"));
    EXPECT_THAT(loader_->listComponentTypes(second), IsEmpty());
}

TEST_F(DeferredLibraries, LibraryThatWaitsIsUnloadedAndImportedAgain) {
    const std::string file = add("lazy", "listed", "loading_listed");
    ASSERT_TRUE(importInstalled("lazy"));
    EXPECT_TRUE(loader_->unloadLibrary(file));
    EXPECT_FALSE(loader_->isImported("lazy"));
    EXPECT_THAT(loader_->listComponentTypes(), Not(Contains("loading_test::Pair<int, int>")));
    EXPECT_FALSE(loader_->unloadLibrary(file));
    ASSERT_TRUE(importInstalled("lazy"));
    EXPECT_TRUE(loader_->reloadLibrary(file));
    EXPECT_TRUE(isMapped(file));
    expectCreated("loading_test::Pair<int, int>");
}

TEST_F(DeferredLibraries, LibraryThatListsNothingIsLoadedAtOnce) {
    const std::string file = add("byhand", "byhand", "loading_handwritten");
    ASSERT_TRUE(importInstalled("byhand"));
    EXPECT_TRUE(isMapped(file));
    expectCreated("loading_test::Handwritten");
}

TEST_F(DeferredLibraries, ThreadsThatNeedItAtTheSameTimeAllGetIt) {
    for (int round = 0; round < 5; ++round) {
        const std::string package = "lazy" + std::to_string(round);
        const std::string file = add(package, "listed", "loading_listed");
        ASSERT_TRUE(importInstalled(package));
        std::vector<std::thread> threads;
        for (int t = 0; t < 4; ++t)
            threads.emplace_back([&, t] {
                if (t == 0) (void)loader_->getFactories();
                RTT::TaskContext* const component =
                    loader_->loadComponent("component" + std::to_string(t), "loading_test::Pair<int, int>");
                EXPECT_TRUE(component && loader_->unloadComponent(component));
            });
        for (std::thread& thread : threads) thread.join();
        EXPECT_TRUE(loader_->unloadLibrary(file));
    }
}

TEST_F(DeferredLibraries, DamagedFilesListNothingOrLess) {
    const std::string file = add("lazy", "listed", "loading_listed");
    std::string bytes = oroforge::test::readFile(file);
    EXPECT_EQ(RTT::plugin::listedTypes(file).size(), 3u);
    EXPECT_THAT(RTT::plugin::listedTypes("/no/such/file"), IsEmpty());
    std::mt19937 random(7);
    const std::string copy = place_ / "copy.so";
    for (int round = 0; round < 500; ++round) {
        std::string damaged = bytes;
        const std::size_t table = *reinterpret_cast<const std::uint64_t*>(bytes.data() + 0x28);
        for (int change = 0; change < 4; ++change)
            damaged[change % 2 ? table + random() % (bytes.size() - table) : random() % 64] =
                static_cast<char>(random());
        if (round % 5 == 0) damaged.resize(random() % damaged.size());
        std::ofstream(copy, std::ios::binary).write(damaged.data(), static_cast<std::streamsize>(damaged.size()));
        EXPECT_LE(RTT::plugin::listedTypes(copy).size(), 100000u);
    }
}

}  // namespace
