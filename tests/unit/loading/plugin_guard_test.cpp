// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What the plugin loader accepts and refuses, plugins written by hand, several threads.
#include "libraries.hpp"

#include <rtt/TaskContext.hpp>
#include <rtt/internal/GlobalService.hpp>

#include <support/temp_dir.hpp>

#include <gmock/gmock.h>

#include <dlfcn.h>

#include <atomic>
#include <filesystem>
#include <functional>
#include <future>
#include <thread>
#include <vector>

namespace {

using loading_test::fileOf;
using loading_test::kTarget;
using RTT::ComponentLoader;
using testing::Contains;
using testing::IsEmpty;
using testing::Not;
using testing::UnorderedElementsAre;

class PluginGuard : public loading_test::PluginLoaderTest {};

TEST_F(PluginGuard, PluginForAnotherVersionIsRefused) {
    EXPECT_EQ("plugin 'loading_old_service' is built for RTT 2.9, this program for RTT 2.10",
              errorOf(fileOf("old/plugins", "loading_old_service")));
    EXPECT_THAT(loader_->listPlugins(), IsEmpty());
}

TEST_F(PluginGuard, ComponentLibraryForAnotherVersionIsRefused) {
    ComponentLoader::Release();
    const ComponentLoader::shared_ptr loader = ComponentLoader::Instance();
    std::string error;
    EXPECT_FALSE(loader->loadLibrary(fileOf("old", "loading_old_component"), error));
    EXPECT_EQ("it is built for RTT 2.9, this program for RTT 2.10", error);
    EXPECT_THAT(loader->listComponentTypes(), Not(Contains("loading_test::Pair<int, int>")));
}

TEST_F(PluginGuard, ExceptionOfAnySymbolIsTold) {
    EXPECT_EQ("plugin 'loading_throwing_name' threw while loading: no name on the box",
              errorOf(fileOf("odd/plugins", "loading_throwing_name")));
}

TEST_F(PluginGuard, PluginByHandIsLoadedAndMayRefuseAComponent) {
    ASSERT_TRUE(loader_->loadPlugins(kTarget + "/byhand"));
    RTT::TaskContext welcome("welcome");
    RTT::TaskContext unwelcome("unwelcome");
    EXPECT_TRUE(loader_->loadService("byhand", &welcome));
    EXPECT_TRUE(welcome.provides("byhand")->hasAttribute("answer"));
    EXPECT_FALSE(loader_->loadService("byhand", &unwelcome));
}

TEST_F(PluginGuard, DirectoryOfALinkToALibraryTellsWhatItIs) {
    const oroforge::test::TempDir workspace;
    std::filesystem::create_directory(workspace / "plugins");
    std::filesystem::copy_file(fileOf("byhand/plugins", "loading_handwritten_service"), workspace / "built.so");
    std::filesystem::create_symlink("../built.so", workspace / "plugins/liblinked.so");
    EXPECT_TRUE(loader_->loadLibrary((workspace / "plugins/liblinked.so").string()));
    EXPECT_THAT(loader_->listServices(), Contains("byhand"));
}

TEST_F(PluginGuard, NoComponentMeansTheGlobalService) {
    ASSERT_TRUE(loader_->loadPlugins(kTarget + "/byhand"));
    EXPECT_TRUE(loader_->loadService("byhand", nullptr));
    EXPECT_TRUE(RTT::internal::GlobalService::Instance()->hasService("byhand"));
    EXPECT_TRUE(loader_->loadService("byhand", nullptr));
    ASSERT_TRUE(loader_->loadPlugins(kTarget + "/slow"));
    EXPECT_FALSE(loader_->loadService("slow", nullptr));
}

TEST_F(PluginGuard, ThreadsThatLoadTheSamePluginStartItOnce) {
    const std::string file = fileOf("slow/plugins", "loading_slow");
    void* const handle = dlopen(file.c_str(), RTLD_NOW);
    ASSERT_NE(nullptr, handle) << dlerror();
    auto* starts = reinterpret_cast<int (*)()>(dlsym(handle, "_Z17loadingTestStartsv"));
    ASSERT_NE(nullptr, starts);
    const int before = starts();
    std::vector<std::thread> threads;
    std::atomic<int> loaded{0};
    for (int i = 0; i < 4; ++i) threads.emplace_back([&] { loaded += loader_->loadLibrary(file); });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(4, loaded);
    EXPECT_EQ(before + 1, starts());
    EXPECT_EQ(1u, loader_->listPlugins().size());
    dlclose(handle);
}

/** A plugin that loads another when it is started, as soon as this one is being started as well. */
class Crossing {
public:
    explicit Crossing(const std::string& name)
        : file(fileOf("crossing/plugins", name)), handle_(dlopen(file.c_str(), RTLD_NOW)) {}
    ~Crossing() {
        setStart({});
        dlclose(handle_);
    }

    void setStart(const std::function<bool()>& start) {
        void* const symbol = dlsym(handle_, "loadingTestSetStart");
        ASSERT_NE(nullptr, symbol) << dlerror();
        reinterpret_cast<void (*)(const std::function<bool()>&)>(symbol)(start);
    }

    const std::string file;

private:
    void* handle_;
};

TEST_F(PluginGuard, PluginsThatLoadEachOtherInTwoThreadsAreBothLoaded) {
    Crossing one("loading_crossing1");
    Crossing two("loading_crossing2");
    std::promise<void> oneStarts;
    std::promise<void> twoStarts;
    const std::future<void> oneStarted = oneStarts.get_future();
    const std::future<void> twoStarted = twoStarts.get_future();
    one.setStart([&] {
        oneStarts.set_value();
        twoStarted.wait();
        return loader_->loadLibrary(two.file);
    });
    two.setStart([&] {
        twoStarts.set_value();
        oneStarted.wait();
        return loader_->loadLibrary(one.file);
    });
    auto first = std::async(std::launch::async, [&] { return loader_->loadLibrary(one.file); });
    EXPECT_TRUE(loader_->loadLibrary(two.file));
    EXPECT_TRUE(first.get());
    EXPECT_THAT(loader_->listPlugins(), UnorderedElementsAre("crossing1", "crossing2"));
}

}  // namespace
