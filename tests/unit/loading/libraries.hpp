// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Where the test libraries lie, and loaders that begin with nothing loaded.
#ifndef OROFORGE_TESTS_LOADING_LIBRARIES_HPP
#define OROFORGE_TESTS_LOADING_LIBRARIES_HPP

#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/plugin/PluginLoader.hpp>

#include <gtest/gtest.h>

#include <dlfcn.h>
#include <string>

namespace loading_test {

inline const std::string kPath = LOADING_TEST_PATH;
inline const std::string kTarget = kPath + "/" OROCOS_TARGET_NAME;

inline std::string fileOf(const std::string& directory, const std::string& name) {
    return kTarget + "/" + directory + "/lib" + name + "-" OROCOS_TARGET_NAME ".so";
}

/** The process has the file loaded, whichever loader asked for it. */
inline bool isMapped(const std::string& file) {
    void* const handle = dlopen(file.c_str(), RTLD_LAZY | RTLD_NOLOAD);
    if (handle) dlclose(handle);
    return handle != nullptr;
}

class ComponentLoaderTest : public testing::Test {
protected:
    ComponentLoaderTest() {
        RTT::ComponentLoader::Release();
        loader_ = RTT::ComponentLoader::Instance();
        loader_->setComponentPath("/nowhere:" + kPath);
    }

    bool import(const std::string& package) { return loader_->import(package, std::string()); }

    RTT::ComponentLoader::shared_ptr loader_;
};

class PluginLoaderTest : public testing::Test {
protected:
    PluginLoaderTest() {
        RTT::plugin::PluginLoader::Release();
        loader_ = RTT::plugin::PluginLoader::Instance();
    }

    std::string errorOf(const std::string& file) {
        std::string error;
        EXPECT_FALSE(loader_->loadLibrary(file, error));
        return error;
    }

    RTT::plugin::PluginLoader::shared_ptr loader_;
};

}  // namespace loading_test

#endif
