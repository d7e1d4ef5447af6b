// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <messages/package_search.hpp>

#include "message_text.hpp"

namespace oroforge::messages {
namespace {

using test::MessageFolder;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(PackageSearch, workspacesComeBeforePrefixes) {
    const test::TempDir dir;
    const std::string root = dir.path().string();
    dir.write("src/group/folder/package.xml", "<package><name> shape_things </name></package>");
    dir.write("src/group/folder/msg/A.msg", "");
    dir.write("src/group/folder/inner/package.xml", "<package><name>inner</name></package>");
    dir.write("src/old_things/manifest.xml", "<package/>");
    dir.write("src/ignored/CATKIN_IGNORE", "");
    dir.write("src/ignored/x/package.xml", "<package><name>ignored_things</name></package>");
    dir.write("prefix/share/shape_things/msg/B.msg", "");
    setenv("ROS_PACKAGE_PATH", (root + "/none:" + root + "/src").c_str(), 1);
    setenv("CMAKE_PREFIX_PATH", (root + "/prefix").c_str(), 1);
    PackageSearch search;
    EXPECT_THAT(search.foldersOf("shape_things", "msg"),
                ElementsAre(root + "/src/group/folder/msg", root + "/prefix/share/shape_things/msg"));
    EXPECT_THAT(search.foldersOf("shape_things", "srv"), ElementsAre());
    EXPECT_EQ(search.folderOf("old_things"), root + "/src/old_things");
    EXPECT_EQ(search.folderOf("inner"), "");
    EXPECT_EQ(search.folderOf("ignored_things"), "");
    EXPECT_THAT(search.described(), HasSubstr(root + "/src"));
    search.add("shape_things", "/given");
    EXPECT_EQ(search.foldersOf("shape_things", "msg")[0], "/given");
}

TEST(PackageSearch, linksInACircle) {
    const test::TempDir dir;
    dir.write("src/a/text", "");
    std::filesystem::create_directory_symlink(dir / "src", dir / "src/a/again");
    setenv("ROS_PACKAGE_PATH", (dir / "src").c_str(), 1);
    PackageSearch search;
    EXPECT_EQ(search.folderOf("nothing_there"), "");
}

TEST(MessageSet, missingPackagesAndMessages) {
    MessageFolder folder;
    folder.write("a/Top", "int8 x\nno_such_msgs/Point point\n");
    EXPECT_FALSE(folder.read("a/Top"));
    EXPECT_THAT(folder.firstError(), testing::StartsWith("Top.msg:2:1: [RM006] 'no_such_msgs/Point': no package "
                                                         "'no_such_msgs' with .msg files; searched: "));
    EXPECT_THAT(folder.firstError(), HasSubstr("Debian: ros-no-such-msgs"));
    MessageFolder second;
    second.write("a/Top", "Point point\n");
    second.write("a/Pointer", "int8 x\n");
    EXPECT_FALSE(second.read("a/Top"));
    EXPECT_EQ(second.firstError(),
              "Top.msg:1:1: [RM006] 'a/Point': package 'a' has no message 'Point'; did you mean 'Pointer'?");
}

TEST(MessageSet, circlesAreTold) {
    MessageFolder folder;
    folder.write("a/Top", "Middle middle\n");
    folder.write("a/Middle", "int8 x\nBottom[] bottom\n");
    folder.write("a/Bottom", "Middle again\n");
    EXPECT_FALSE(folder.read("a/Top"));
    ASSERT_EQ(folder.sink.errorCount(), 1u);
    EXPECT_THAT(folder.firstError(), testing::StartsWith("Middle.msg:2:1: [RM007] a 'a/Middle' contains itself"));
    ASSERT_EQ(folder.sink.all()[0].notes.size(), 2u);
    EXPECT_EQ(folder.sink.all()[0].notes[1].message, "through field 'again' of 'a/Bottom'");
    MessageFolder own;
    own.write("a/Top", "Top[] parts\n");
    EXPECT_FALSE(own.read("a/Top"));
    EXPECT_THAT(own.firstError(), HasSubstr("RM007"));
}

TEST(MessageSet, deepChains) {
    MessageFolder folder;
    for (int i = 0; i != 300; ++i) folder.write("a/M" + std::to_string(i), "M" + std::to_string(i + 1) + " next\n");
    folder.write("a/M300", "int8 x\n");
    EXPECT_TRUE(folder.read("a/M0")) << folder.firstError();
    EXPECT_EQ(folder.set.files().size(), 301u);
}

TEST(MessageSet, faultsInPartsAreToldOnce) {
    MessageFolder folder;
    folder.write("a/Top", "Part one\nPart two\n");
    folder.write("a/Part", "oops\n");
    EXPECT_FALSE(folder.read("a/Top"));
    EXPECT_EQ(folder.sink.errorCount(), 1u);
    EXPECT_THAT(folder.firstError(), testing::StartsWith("Part.msg:1:1: [RM002]"));
}

}  // namespace
}  // namespace oroforge::messages
