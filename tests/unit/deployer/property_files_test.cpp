// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "file_opens.hpp"

#include <deployment/property_files.hpp>

#include <support/temp_dir.hpp>

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

namespace {

using OCL::deploy::PropertyFiles;
using oroforge::diag::Sink;

std::string number(const std::string& value) {
    return "<properties><simple name='x' type='long'><value>" + value + "</value></simple></properties>\n";
}

class PropertyFilesTest : public testing::Test {
protected:
    void write(const std::string& text) { std::ofstream(path_) << text; }
    /** Writes and waits until the next change has another time. */
    void writeAndWait(const std::string& text) {
        write(text);
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    std::string value() {
        const auto* file = files_.read(path_, sink_);
        if (!file) return "errors";
        return std::to_string(*static_cast<const int*>(file->bag.find("x")->getDataSource()->getRawConstPointer()));
    }

    const oroforge::test::TempDir directory_;
    const std::string path_ = (directory_.path() / "x.cpf").string();
    PropertyFiles files_;
    Sink sink_;
};

TEST_F(PropertyFilesTest, AFileIsReadOnce) {
    writeAndWait(number("1"));
    deployer_test::FileOpens opens(path_);
    EXPECT_EQ("1", value());
    EXPECT_EQ("1", value());
    EXPECT_NE(nullptr, files_.readAgain(path_));
    EXPECT_EQ(1, opens.count());
    files_.clear();
    EXPECT_EQ("1", value());
    EXPECT_EQ(1, opens.count());
}

TEST_F(PropertyFilesTest, AChangedFileIsReadAgain) {
    writeAndWait(number("1"));
    EXPECT_EQ("1", value());
    writeAndWait(number("2"));  // of the same size, in the same place
    EXPECT_EQ("2", value());
    const std::string other = (directory_.path() / "other").string();
    std::ofstream(other) << number("3");
    const auto time = std::filesystem::last_write_time(path_);
    std::filesystem::rename(other, path_);
    std::filesystem::last_write_time(path_, time);
    EXPECT_EQ("3", value());
    std::filesystem::remove(path_);
    EXPECT_EQ("errors", value());
    EXPECT_TRUE(sink_.hadErrors());
}

TEST_F(PropertyFilesTest, AFileThatChangesTwiceWithinATickIsReadAgain) {
    for (int i = 10; i != 90; ++i) {
        write(number(std::to_string(i)));
        EXPECT_EQ(std::to_string(i), value());
    }
}

TEST_F(PropertyFilesTest, ErrorsAreToldEachTimeAndWarningsOnce) {
    writeAndWait("<properties><other/><simple name='x' type='long'><value>y</value></simple></properties>\n");
    EXPECT_EQ("errors", value());
    EXPECT_EQ(nullptr, files_.readAgain(path_));
    EXPECT_EQ(1u, sink_.errorCount());
    EXPECT_EQ("errors", value());
    EXPECT_EQ(2u, sink_.errorCount());
    writeAndWait("<properties><other/><simple name='x' type='long'><value>1</value></simple></properties>\n");
    const std::size_t before = sink_.warningCount();
    EXPECT_EQ("1", value());
    EXPECT_EQ("1", value());
    EXPECT_EQ(before + 1, sink_.warningCount());
}

TEST_F(PropertyFilesTest, AWarningThatReadAgainFindsIsReportedByTheNextRead) {
    writeAndWait(number("1"));
    EXPECT_EQ("1", value());
    writeAndWait("<properties><other/><simple name='x' type='long'><value>2</value></simple></properties>\n");
    EXPECT_NE(nullptr, files_.readAgain(path_));
    EXPECT_EQ(0u, sink_.warningCount());
    EXPECT_EQ("2", value());
    EXPECT_EQ("2", value());
    EXPECT_EQ(1u, sink_.warningCount());
}

}  // namespace
