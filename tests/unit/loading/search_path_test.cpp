// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/plugin/search_path.hpp>
#include <rtt/rtt-config.h>

#include <support/temp_dir.hpp>

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>

namespace {

using namespace RTT::plugin;
using oroforge::test::TempDir;
using testing::ElementsAre;
using testing::EndsWith;
using testing::IsEmpty;
using testing::StartsWith;

TEST(SearchPath, ListIsSplitAtColonsAndSemicolonsWithoutRepeats) {
    EXPECT_THAT(splitPathList("/a:/b;/a/::/c"), ElementsAre("/a", "/b", "/c"));
    EXPECT_THAT(splitPathList(""), IsEmpty());
    EXPECT_THAT(splitPathList("/"), ElementsAre("/"));
}

TEST(SearchPath, EnvironmentComesBeforeTheInstallation) {
    const char* kept = std::getenv("RTT_COMPONENT_PATH");
    const std::string old = kept ? kept : "";
    setenv("RTT_COMPONENT_PATH", "/workspace/lib/orocos", 1);
    const std::string path = defaultSearchPath();
    setenv("RTT_COMPONENT_PATH", old.c_str(), 1);
    EXPECT_THAT(path, StartsWith("/workspace/lib/orocos:"));
    EXPECT_THAT(path, EndsWith("/orocos"));
}

TEST(SearchPath, ShortNameHasNeitherDirectoryNorPrefixNorTargetNorSuffix) {
    EXPECT_EQ("robot", shortName("/lib/librobot-" OROCOS_TARGET_NAME ".so"));
    EXPECT_EQ("robot", shortName("robot-" OROCOS_TARGET_NAME ".so.2.10"));
    EXPECT_EQ("robot", shortName("librobot.so"));
    EXPECT_EQ("robot", shortName("robot"));
    EXPECT_EQ("lib", shortName("lib"));
}

TEST(SearchPath, LibrariesAreSharedObjectsWithOrWithoutVersion) {
    const TempDir dir;
    for (const char* name : {"libb.so", "liba.so.1.2", "a.so.old", "notes.txt", "so", "libc.sox"}) dir.write(name, "");
    std::filesystem::create_directory(dir / "d.so");
    const std::string base = dir.path().string();
    EXPECT_THAT(librariesIn(base), ElementsAre(base + "/liba.so.1.2", base + "/libb.so"));
    EXPECT_THAT(librariesIn(base + "/none"), IsEmpty());
}

TEST(SearchPath, TargetDirectoryIsAddedOnce) {
    const TempDir dir;
    const std::string base = dir.path().string();
    const std::string target = base + "/" OROCOS_TARGET_NAME;
    EXPECT_THAT(withTargetDirectory(base), ElementsAre(base));
    std::filesystem::create_directory(target);
    EXPECT_THAT(withTargetDirectory(base), ElementsAre(base, target));
    EXPECT_THAT(withTargetDirectory(target), ElementsAre(target));
    EXPECT_THAT(withTargetDirectory(base + "/none"), IsEmpty());
}

}  // namespace
