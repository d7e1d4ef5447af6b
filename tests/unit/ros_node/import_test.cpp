// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// ros.import, ros.find and their users. Which packages are found is tested in tests/unit/loading.
#include "programs.hpp"

#include <gmock/gmock.h>

namespace {

using namespace ros_node_test;
using oroforge::test::Outcome;
using oroforge::test::TempDir;
using testing::HasSubstr;

struct RosImport : testing::Test {
    RosImport() {
        useToolchain();
        setenv("ROS_PACKAGE_PATH", (folder_.path().string() + ":" + kPrefix + "/share").c_str(), 1);
    }
    Outcome script(const std::string& text) {
        folder_.write("x.ops",
                      "import(\"rtt_ros\")\nimport(\"rtt_rospack\")\nloadService(\"Deployer\", \"print\")\n" + text);
        return oroforge::test::run(program("rttscript", {"-s", "x.ops"}, folder_));
    }
    TempDir folder_;
};

TEST_F(RosImport, ScriptsImportAndFindPackages) {
    folder_.write(
        "one/package.xml",
        "<package><name>one</name><export><rtt_ros><plugin_depend>two</plugin_depend></rtt_ros></export></package>");
    folder_.write(
        "two/package.xml",
        "<package><name>two</name><export><rtt_ros><plugin_depend>one</plugin_depend></rtt_ros></export></package>");
    folder_.write("bad/package.xml", "<package>\n<name>bad<name></package>");
    const Outcome done = script(
        "if ros.import(\"one\") then "
        "print.ln(\"true\")\nprint.ln(ros.find(\"two\"))\nprint.ln(rospack.find(\"rtt_ros\"))\n"
        "print.ln(\"[\" + ros.find(\"none\") + \"]\")\nvar bool bad = ros.import(\"bad\")\nif bad then "
        "print.ln(\"good\")\n");
    EXPECT_EQ(0, done.status) << done.err;
    EXPECT_THAT(done.out, HasSubstr("true\n" + folder_.path().string() + "/two\n" + kPrefix + "/share/rtt_ros\n"));
    EXPECT_THAT(done.out, HasSubstr("[]\n"));
    EXPECT_THAT(done.out + done.err, HasSubstr("/bad/package.xml:2:"));
    EXPECT_THAT(done.out, testing::Not(HasSubstr("good")));
}

TEST_F(RosImport, LuaFindsPackages) {
    folder_.write("x.lua",
                  "require 'rttlib'\nlocal rttros = require 'rttros'\nprint(rttros.find_rospack('rtt_rosnode'))\n"
                  "print(rttros.rospack_find('none'))\n");
    auto command = program("rttlua", {"x.lua"}, folder_);
    const Outcome done = oroforge::test::run(command);
    EXPECT_EQ(0, done.status) << done.err;
    EXPECT_THAT(done.out, HasSubstr(kPrefix + "/share/rtt_rosnode\nfalse\tthere is no ROS package 'none'\n"));
}

}  // namespace
