// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Files that are full, removed, begun anew.
#include "appender_fixture.hpp"

#include <ocl/GenerationalFileAppender.hpp>
#include <ocl/RollingFileAppender.hpp>
#include <rtt/OperationCaller.hpp>

#include <cstdlib>
#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>

namespace {

using namespace logging_test;

TEST_F(Appenders, ATornLineOfBeforeIsEndedFirst) {
    folder.write("log", "whole\ntorn");
    Stepped<OCL::logging::FileAppender> file;
    prepare(file);
    begin(file);
    log("one");
    ASSERT_TRUE(file.update());
    EXPECT_EQ("whole\ntorn\nINFO " + name + " one\n", text());
}

TEST_F(Appenders, FullDiskIsReportedOnceAndWritingGoesOn) {
    const LogText said;
    Stepped<OCL::logging::FileAppender> file;
    prepare(file);
    begin(file);
    log("one");
    ASSERT_TRUE(file.update());
    // The file is replaced by a device that is always full.
    ASSERT_EQ(0, unlink(path("log").c_str()));
    ASSERT_EQ(0, symlink("/dev/full", path("log").c_str()));
    for (int i = 0; i < 3; ++i) {
        log("lost");
        ASSERT_TRUE(file.update());
    }
    EXPECT_THAT(said(),
                HasSubstr("appender 'out' cannot write to file '" + path("log") + "': No space left on device"));
    EXPECT_EQ(1u, timesIn(said(), "cannot write"));
    RTT::OperationCaller<unsigned int()> lost = file.getOperation("lostEvents");
    EXPECT_EQ(3u, lost());
    file.stop();
    EXPECT_THAT(said(), HasSubstr("appender 'out' has lost 4 events"));
    ASSERT_EQ(0, unlink(path("log").c_str()));
    ASSERT_TRUE(file.start());
    log("again");
    ASSERT_TRUE(file.update());
    EXPECT_EQ("INFO " + name + " again\n", text());
}

TEST_F(Appenders, FullFileLosesWholeRecordsOnly) {
    if (geteuid() != 0) GTEST_SKIP() << "only root can mount";
    const std::string disk = path("disk");
    ASSERT_EQ(0, mkdir(disk.c_str(), 0700));
    if (std::system(("mount -t tmpfs -o size=8k none " + disk + " 2> /dev/null").c_str()) != 0)
        GTEST_SKIP() << "this container cannot mount";
    {
        const LogText said;
        Stepped<OCL::logging::FileAppender> file;
        prepare(file);
        property<std::string>(file, "Filename") = disk + "/log";
        begin(file);
        const std::string record = "INFO " + name + " " + std::string(100, 'x');
        for (int i = 0; i < 90; ++i) {
            log(std::string(100, 'x'));
            ASSERT_TRUE(file.update());
        }
        EXPECT_THAT(said(), HasSubstr("No space left on device"));
        const std::string written = readFile(disk + "/log");
        EXPECT_GT(written.size(), 7000u);
        for (const std::string& line : linesOf(written)) ASSERT_EQ(record, line);
        EXPECT_EQ('\n', written.back());
        ASSERT_EQ(0, truncate((disk + "/log").c_str(), 0));  // there is room again
        log("after");
        ASSERT_TRUE(file.update());
        EXPECT_THAT(readFile(disk + "/log"), HasSubstr("INFO " + name + " after\n"));
        EXPECT_THAT(said(), HasSubstr("can write to file '" + disk + "/log' again"));
    }
    EXPECT_EQ(0, std::system(("umount " + disk).c_str()));
}

TEST_F(Appenders, RemovedFolderIsReportedOnceAndTheFileComesBack) {
    const LogText said;
    Stepped<OCL::logging::FileAppender> file;
    prepare(file);
    ASSERT_EQ(0, mkdir(path("sub").c_str(), 0700));
    property<std::string>(file, "Filename") = path("sub/log");
    begin(file);
    log("one");
    ASSERT_TRUE(file.update());
    std::filesystem::remove_all(folder / "sub");
    log("lost"), log("lost");
    ASSERT_TRUE(file.update());
    log("lost");
    ASSERT_TRUE(file.update());
    EXPECT_THAT(said(),
                HasSubstr("appender 'out' cannot write to file '" + path("sub/log") + "': No such file or directory"));
    ASSERT_EQ(0, mkdir(path("sub").c_str(), 0700));
    log("two");
    ASSERT_TRUE(file.update());
    EXPECT_EQ("INFO " + name + " two\n", text("sub/log"));
    EXPECT_THAT(said(), HasSubstr("again; 3 events were lost"));
    EXPECT_EQ(1u, timesIn(said(), "cannot write"));
}

TEST_F(Appenders, RollingFileKeepsSoManyFormerFiles) {
    Stepped<OCL::logging::RollingFileAppender> file;
    prepare(file);
    file.layout("pattern", "%m%n");
    property<int>(file, "MaxFileSize") = 30;
    property<int>(file, "MaxBackupIndex") = 2;
    begin(file);
    for (int i = 10; i < 40; ++i) {
        log("event " + std::to_string(i));
        ASSERT_TRUE(file.update());
    }
    // Four records of nine bytes reach the size; then it is begun anew.
    EXPECT_EQ("event 38\nevent 39\n", text());
    EXPECT_EQ("event 34\nevent 35\nevent 36\nevent 37\n", text("log.1"));
    EXPECT_EQ("event 30\nevent 31\nevent 32\nevent 33\n", text("log.2"));
    EXPECT_FALSE(std::filesystem::exists(folder / "log.3"));
}

TEST_F(Appenders, RollingFileWithoutFormerFilesIsEmptied) {
    Stepped<OCL::logging::RollingFileAppender> file;
    prepare(file);
    file.layout("pattern", "%m%n");
    property<int>(file, "MaxFileSize") = 100;
    property<int>(file, "MaxBackupIndex") = 0;
    begin(file);
    for (int i = 0; i < 50; ++i) log("event " + std::to_string(i));
    ASSERT_TRUE(file.update());
    EXPECT_LT(text().size(), 110u);
    EXPECT_FALSE(std::filesystem::exists(folder / "log.1"));
}

TEST_F(Appenders, RollingFileGoesOnWhenItCannotBeRenamed) {
    const LogText said;
    Stepped<OCL::logging::RollingFileAppender> file;
    prepare(file);
    property<int>(file, "MaxFileSize") = 20;
    ASSERT_EQ(0, mkdir(path("log.1").c_str(), 0700));  // a folder is in the way
    folder.write("log.1/x", "");
    begin(file);
    for (int i = 0; i < 10; ++i) log("event");
    ASSERT_TRUE(file.update());
    EXPECT_EQ(10u, linesOf(text()).size());
    EXPECT_THAT(said(),
                HasSubstr("appender 'out' cannot begin file '" + path("log") + "' anew, so it goes on with it"));
    EXPECT_EQ(1u, timesIn(said(), "cannot begin"));
}

TEST_F(Appenders, GenerationsNeverOverwriteEachOther) {
    const LogText said;
    Stepped<OCL::logging::GenerationalFileAppender> file;
    prepare(file);
    file.layout("pattern", "%m%n");
    folder.write("log.1", "of yesterday\n");
    file.advanceGeneration();
    EXPECT_THAT(said(), HasSubstr("No appender to roll over!"));
    begin(file);
    log("a");
    ASSERT_TRUE(file.update());
    file.advanceGeneration();
    log("b");
    ASSERT_TRUE(file.update());
    file.advanceGeneration();
    log("c");
    ASSERT_TRUE(file.update());
    EXPECT_EQ("of yesterday\n", text("log.1"));
    EXPECT_EQ("a\n", text("log.2"));
    EXPECT_EQ("b\n", text("log.3"));
    EXPECT_EQ("c\n", text());
    EXPECT_NE(nullptr, file.getOperation("advanceGeneration"));
}

}  // namespace
