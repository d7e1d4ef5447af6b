// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Libraries that are linked with those of packages in other prefixes.
#include "libraries.hpp"

#include <gmock/gmock.h>

#include <filesystem>

namespace fs = std::filesystem;

namespace {

using RTT::ComponentLoader;
using RTT::plugin::PluginLoader;
using testing::Contains;
using testing::HasSubstr;

class NeededLibrary : public testing::Test {
protected:
    NeededLibrary() {
        ComponentLoader::Release();
        PluginLoader::Release();
        setPath(first_ + ":" + second_);
    }

    void setPath(const std::string& path) {
        ComponentLoader::Instance()->setComponentPath(path);
        PluginLoader::Instance()->setPluginPath(path);
    }

    std::string errorOfImport(const std::string& package) {
        std::string error;
        ComponentLoader::Instance()->import(package, std::string(), error);
        return error;
    }

    const std::string prefixes_ = LOADING_TEST_PREFIXES;
    const std::string first_ = prefixes_ + "/first/lib/orocos", second_ = prefixes_ + "/second/lib/orocos";
};

TEST_F(NeededLibrary, OfNoPackageOnThePathIsNamedWithItsPackage) {
    EXPECT_EQ(errorOfImport("loading_loser"),
              second_ +
                  "/" OROCOS_TARGET_NAME "/loading_loser/libloading_loser-" OROCOS_TARGET_NAME
                  ".so: it needs libloading_lost-typekit-" OROCOS_TARGET_NAME
                  ".so, which is not found; install the package 'loading_lost', or add the folder lib/orocos of its "
                  "prefix to the search path (RTT_COMPONENT_PATH), which is " +
                  first_ + ":" + second_);
}

TEST_F(NeededLibrary, ThatOthersMayWriteToIsRefused) {
    const fs::path copy = fs::path(prefixes_) / "writable/lib/orocos" / OROCOS_TARGET_NAME / "loading_lost/types";
    const std::string name = "libloading_lost-typekit-" OROCOS_TARGET_NAME ".so";
    fs::create_directories(copy);
    fs::copy_file(fs::path(prefixes_) / "lost" / name, copy / name, fs::copy_options::overwrite_existing);
    fs::permissions(copy / name, fs::perms::others_write, fs::perm_options::add);
    setPath(prefixes_ + "/writable/lib/orocos:" + second_);
    EXPECT_THAT(errorOfImport("loading_loser"),
                HasSubstr("it needs " + (copy / name).string() + ", which cannot be loaded: "));
    fs::remove_all(fs::path(prefixes_) / "writable");
}

// The last of these tests: the libraries stay in the process.
TEST_F(NeededLibrary, OfAnotherPrefixIsLoadedBeforeAsItsImportWould) {
    EXPECT_EQ(errorOfImport("loading_user"), "");
    EXPECT_THAT(PluginLoader::Instance()->listPlugins(), testing::IsEmpty());
    EXPECT_THAT(PluginLoader::Instance()->listTypekits(), Contains("loading_base"));
    EXPECT_THAT(ComponentLoader::Instance()->listComponentTypes(), testing::Not(testing::IsEmpty()));
}

}  // namespace
