// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <ros_driver/typegen_ros.hpp>

#include <cstdlib>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/temp_dir.hpp"

namespace oroforge::messages {
namespace {

using test::TempDir;
using testing::HasSubstr;
using testing::Not;

struct Ran {
    int status;
    std::string out, err;
};

Ran run(const std::vector<std::string>& words) {
    std::ostringstream out, err;
    const int status = runTypegenRos(words, out, err);
    return {status, out.str(), err.str()};
}

TEST(TypegenRos, commandLine) {
    EXPECT_THAT(run({"--help"}).out, HasSubstr("usage: typegen-ros --messages PACKAGE"));
    EXPECT_THAT(run({"--version"}).out, HasSubstr("typegen-ros 2."));
    EXPECT_THAT(run({}).err, HasSubstr("[RM008] nothing to do"));
    EXPECT_THAT(run({"--mesages", "x"}).err, HasSubstr("did you mean '--messages'"));
    EXPECT_THAT(run({"--messages", "x"}).err, HasSubstr("[RM008] no output folder"));
    EXPECT_THAT(run({"--messages", "--services", "x", "-o", "y"}).err, HasSubstr("exclude each other"));
    EXPECT_THAT(run({"--messages", "x", "-o", "y", "--path=z"}).err, HasSubstr("is not '--path=PACKAGE=FOLDER'"));
    EXPECT_THAT(run({"--messages", "x", "-o", "y", "--per-source=0"}).err, HasSubstr("not a number of messages"));
    EXPECT_THAT(run({"--md5", "x"}).err, HasSubstr("'x' is not PACKAGE/NAME"));
    EXPECT_THAT(run({"--explain", "RM007"}).out, HasSubstr("RM007"));
    EXPECT_EQ(run({"--messages"}).status, 1);
}

TEST(TypegenRos, packagesAreFoundAndFilesWritten) {
    const TempDir dir;
    dir.write("share/demo/msg/A.msg", "other/B b\n");
    dir.write("share/demo/srv/S.srv", "A a\n---\nthird/C c\n");
    dir.write("share/other/msg/B.msg", "int8 x\n");
    dir.write("share/third/msg/C.msg", "int8 x\n");
    dir.write("share/empty/package.xml", "<package/>");
    setenv("CMAKE_PREFIX_PATH", dir.path().c_str(), 1);
    const std::string out = (dir / "out").string();
    Ran ran = run({"--messages", "demo", "-o", out, "--depfile=" + out + ".d", "--depfile-target=stamp"});
    EXPECT_EQ(ran.err, "");
    EXPECT_THAT(test::readFile(dir / "out/types_A.cpp"), HasSubstr("/demo/A"));
    const std::string depfile = test::readFile(out + ".d");
    EXPECT_THAT(depfile, HasSubstr("stamp:"));
    EXPECT_THAT(depfile, HasSubstr("share/other/msg/B.msg"));
    ran = run({"--services", "demo", "-o", out});
    EXPECT_EQ(ran.err, "");
    EXPECT_THAT(test::readFile(dir / "out/Services.cpp"), HasSubstr("rtt_demo_ros_service_proxies"));
    EXPECT_THAT(test::readFile(dir / "out/types_SRequest.cpp"), HasSubstr("/demo/SResponse"));
    EXPECT_EQ(run({"--dependencies", "demo"}).out, "other\nthird\n");
    EXPECT_EQ(run({"--md5", "demo/S"}).out.size(), 33u);
    EXPECT_THAT(run({"--definition", "demo/A"}).out, HasSubstr("MSG: other/B\nint8 x"));
    EXPECT_THAT(run({"--messages", "demo", "-o", out, "--list-outputs"}).out, HasSubstr(out + "/Plugin.cpp"));
    EXPECT_THAT(run({"--messages", "empty", "-o", out}).err, HasSubstr("[RM006] package 'empty' has no .msg files"));
    EXPECT_THAT(run({"--messages", "no_such", "-o", out}).err, HasSubstr("[RM006] no package 'no_such'"));
}

TEST(TypegenRos, nothingIsWrittenAfterErrors) {
    const TempDir dir;
    const std::string file = dir.write("msg/A.msg", "int8 x\nSome thing\n").string(), out = (dir / "out").string();
    const Ran ran = run({"--messages", "demo", file, "-o", out});
    EXPECT_EQ(ran.status, 1);
    EXPECT_THAT(ran.err, HasSubstr(file + ":2:1: error: [RM006] 'demo/Some': package 'demo' has no message 'Some'"));
    EXPECT_FALSE(std::filesystem::exists(out));
    EXPECT_THAT(run({"--messages", "demo", (dir / "none.msg").string(), "-o", out}).err,
                HasSubstr("[RM001] cannot read"));
    // A message beside a service whose half has its name.
    const std::string service = dir.write("srv/A.srv", "ARequest own\n---\n").string();
    dir.write("msg/ARequest.msg", "int8 x\n");
    EXPECT_THAT(run({"--services", "demo", service, "-o", out, "--path=demo=" + (dir / "msg").string()}).err,
                HasSubstr("RM007"));
}

TEST(TypegenRos, documentForPrograms) {
    const Ran ran = run({"--format=json", "--messages", "no_such", "-o", "/nowhere"});
    EXPECT_EQ(ran.status, 1);
    EXPECT_THAT(ran.out, HasSubstr("\"RM006\""));
}

}  // namespace
}  // namespace oroforge::messages
