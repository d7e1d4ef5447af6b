// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "libraries.hpp"

#include <rtt/deployment/ros_packages.hpp>
#include <support/temp_dir.hpp>

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>

namespace {

using loading_test::kTarget;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/** A workspace of ROS packages whose libraries are those of the tests. */
class RosPackages : public loading_test::ComponentLoaderTest {
protected:
    RosPackages() { setenv("ROS_PACKAGE_PATH", ("/nowhere:" + workspace_.path().string()).c_str(), 1); }
    ~RosPackages() override { unsetenv("ROS_PACKAGE_PATH"); }

    /** `where` relative to lib/orocos of the package. */
    void addLibraries(const std::string& package, const std::string& libraries, const std::string& where) {
        const auto link = workspace_.path() / package / "lib/orocos" / where;
        std::filesystem::create_directories(link.parent_path());
        std::filesystem::create_directory_symlink(kTarget + "/" + libraries, link);
    }
    void addCatkin(const std::string& directory, const std::string& name, const std::string& dependencies) {
        workspace_.write(directory + "/package.xml",
                         "<package format=\"2\">\n  <name>\n" + name + " </name>" + dependencies + "</package>\n");
    }
    std::string errorOf(const std::string& package) {
        std::string error;
        EXPECT_FALSE(loader_->import(package, std::string(), error));
        return error;
    }

    oroforge::test::TempDir workspace_;
};

TEST_F(RosPackages, LibrariesOfThePackageAndOfAllItDependsOnAreImported) {
    addCatkin("stack/some_folder", "ros_robot",
              "<exec_depend>ros_arm</exec_depend><depend>roscpp</depend><build_depend>ros_other</build_depend>");
    workspace_.write("ros_arm/manifest.xml", "<package><depend package=\"ros_base\"/></package>");
    addCatkin("ros_base", "ros_base", "<run_depend>ros_robot</run_depend>");  // a cycle does no harm
    addCatkin("ros_other", "ros_other", "");
    addLibraries("stack/some_folder", "single", OROCOS_TARGET_NAME "/ros_robot");
    addLibraries("ros_base", "listed", OROCOS_TARGET_NAME);
    addLibraries("ros_other", "several", OROCOS_TARGET_NAME);
    EXPECT_TRUE(import("ros_robot"));
    EXPECT_THAT(loader_->listComponentTypes(), Contains("loading_test::Single"));
    EXPECT_TRUE(loader_->isImported("ros_base"));
    EXPECT_FALSE(loader_->isImported("ros_other"));
    EXPECT_TRUE(import("ros_robot"));
}

TEST_F(RosPackages, ThoseOnTheSearchPathGoFirst) {
    addCatkin("single", "single", "");
    addLibraries("single", "several", OROCOS_TARGET_NAME);
    EXPECT_TRUE(import("single"));
    EXPECT_THAT(loader_->listComponentTypes(), Not(Contains("loading_test::First")));
}

TEST_F(RosPackages, WhatIsIgnoredOrInsideAPackageIsNoPackage) {
    addCatkin("outer", "ros_outer", "");
    addCatkin("outer/inner", "ros_inner", "");
    addCatkin("ignored/one", "ros_ignored", "");
    workspace_.write("ignored/CATKIN_IGNORE", "");
    addCatkin("flat/one", "ros_flat", "");
    workspace_.write("flat/rospack_nosubdirs", "");
    EXPECT_THAT(errorOf("ros_inner"), HasSubstr("no such package"));
    EXPECT_THAT(errorOf("ros_ignored"), HasSubstr("no such package"));
    EXPECT_THAT(errorOf("ros_flat"), HasSubstr("no such package"));
    EXPECT_THAT(errorOf("ros_outer"), HasSubstr("ROS package 'ros_outer' has no components, typekits or plugins in"));
}

TEST_F(RosPackages, APackageFileThatCannotBeReadIsLeftOut) {
    workspace_.write("ros_broken/package.xml", "<package><name>ros_broken</name>");
    addCatkin("good", "ros_good", "");
    addLibraries("good", "single", OROCOS_TARGET_NAME "/ros_good");
    EXPECT_TRUE(import("ros_good"));
    EXPECT_THAT(errorOf("ros_broken"),
                AllOf(HasSubstr("no such package"), HasSubstr("/ros_broken/package.xml:1:1: error")));
}

/** importRos(), as the service `ros` calls it. */
class RosImport : public RosPackages {
protected:
    void addPlugins(const std::string& directory, const std::string& name, const std::vector<std::string>& plugins) {
        std::string text;
        for (const std::string& one : plugins) text += "<plugin_depend>" + one + "</plugin_depend>";
        addCatkin(directory, name, "<export><rtt_ros>" + text + "</rtt_ros></export>");
    }
    std::string importRos(const std::string& package) {
        std::string error;
        const bool done = loader_->importRos(package, error);
        EXPECT_EQ(done, error.empty());
        return error;
    }
};

TEST_F(RosImport, PluginsThatAPackageNamesComeFirstAndOnce) {
    addPlugins("ros_robot", "ros_robot", {"ros_arm", "rtt_ros"});
    addPlugins("ros_arm", "ros_arm", {"ros_robot", "ros_plain"});  // a cycle
    addCatkin("ros_plain", "ros_plain", "<exec_depend>ros_other</exec_depend>");
    addCatkin("ros_other", "ros_other", "");
    addLibraries("ros_robot", "single", OROCOS_TARGET_NAME "/ros_robot");
    addLibraries("ros_arm", "several", OROCOS_TARGET_NAME);
    addLibraries("ros_other", "listed", OROCOS_TARGET_NAME);
    EXPECT_EQ("", importRos("ros_robot"));
    EXPECT_TRUE(loader_->isImported("ros_robot"));
    EXPECT_TRUE(loader_->isImported("ros_arm"));
    EXPECT_FALSE(loader_->isImported("ros_other"));  // what it needs at run time is not imported
    EXPECT_EQ("", importRos("ros_robot"));
    EXPECT_EQ("", importRos("ros_plain"));  // has no libraries
}

TEST_F(RosImport, WhatIsMissingIsSaidAndTheOthersAreImported) {
    addPlugins("ros_robot", "ros_robot", {"ros_gone", "ros_broken"});
    workspace_.write("ros_broken/package.xml", "<package>\n  <name>ros_broken</nam>\n</package>");
    addLibraries("ros_robot", "single", OROCOS_TARGET_NAME "/ros_robot");
    const std::string error = importRos("ros_robot");
    EXPECT_THAT(error,
                HasSubstr("there is no package 'ros_gone', which package.xml of 'ros_robot' names; ROS_PACKAGE_"));
    EXPECT_THAT(error, HasSubstr("ros_broken/package.xml:2:"));
    EXPECT_TRUE(loader_->isImported("ros_robot"));
}

TEST_F(RosImport, AMisspelledPackageGetsAHint) {
    std::filesystem::create_directories(workspace_.path() / "path");
    std::filesystem::create_directory_symlink(kTarget + "/single", workspace_.path() / "path/ros_robot");
    loader_->setComponentPath((workspace_.path() / "path").string());
    EXPECT_THAT(importRos("ros_rovot"), HasSubstr("there is no package 'ros_rovot'; ROS_PACKAGE_PATH"));
    EXPECT_THAT(importRos("ros_rovot"), HasSubstr("did you mean 'ros_robot'?"));
}

TEST_F(RosImport, PackagesOfPrefixesAreFoundWithoutRosPackagePath) {
    unsetenv("ROS_PACKAGE_PATH");
    setenv("CMAKE_PREFIX_PATH", workspace_.path().c_str(), 1);
    addPlugins("share/ros_robot", "ros_robot", {});
    std::filesystem::create_directories(workspace_.path() / "lib/orocos/" OROCOS_TARGET_NAME);
    std::filesystem::create_directory_symlink(kTarget + "/single",
                                              workspace_.path() / "lib/orocos/" OROCOS_TARGET_NAME "/ros_robot");
    EXPECT_EQ("", importRos("ros_robot"));
    EXPECT_THAT(loader_->listComponentTypes(), Contains("loading_test::Single"));
    RTT::plugin::RosPackages packages;
    ASSERT_NE(nullptr, packages.find("ros_robot"));
    EXPECT_EQ(workspace_.path().string() + "/share/ros_robot", packages.find("ros_robot")->directory);
    EXPECT_EQ(nullptr, packages.find("../share/ros_robot"));
    unsetenv("CMAKE_PREFIX_PATH");
}

TEST_F(RosImport, RosbuildPackagesHideThoseOnTheSearchPath) {
    workspace_.write("single/manifest.xml", "<package/>");
    addLibraries("single", "several", OROCOS_TARGET_NAME);
    EXPECT_EQ("", importRos("single"));
    EXPECT_THAT(loader_->listComponentTypes(), Contains("loading_test::First"));
}

}  // namespace
