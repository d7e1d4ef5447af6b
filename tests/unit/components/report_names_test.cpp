// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Components whose names are paths, or begin other lines: C++ makes them, no deployer does.
#include "reporter_fixture.hpp"

#include <ocl/FileReporting.hpp>
#include <support/temp_dir.hpp>

#include <filesystem>
#include <memory>

namespace {

using namespace components_test;
using oroforge::test::TempDir;

class ReportNames : public Reporting {
protected:
    ReportNames() : old_(std::filesystem::current_path()) {
        directory_.write("inner/here", "");
        std::filesystem::current_path(directory_ / "inner");
    }
    ~ReportNames() override { std::filesystem::current_path(old_); }

    /** A peer of that name, with a port. */
    void peer(RTT::TaskContext& reporter, const std::string& name) {
        named_ = std::make_unique<RTT::TaskContext>(name);
        named_->ports()->addPort(port_);
        ASSERT_TRUE(reporter.addPeer(named_.get()));
    }
    /** All files of both folders. */
    std::vector<std::string> files() const {
        std::vector<std::string> found;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(directory_.path()))
            found.push_back(entry.path().lexically_relative(directory_.path()));
        std::sort(found.begin(), found.end());
        return found;
    }

    TempDir directory_;
    RTT::OutputPort<double> port_{"port"};
    std::unique_ptr<RTT::TaskContext> named_;

private:
    const std::filesystem::path old_;
};

const char* const kForging[] = {"a\n9.999 forged", "a\x1b[2J", "a\tb", "a\x7f"};

TEST_F(ReportNames, ScreensAreWrittenIntoThisFolderOnly) {
    const LogText log;
    for (const char* name : {"../x", "a/b", "/tmp/x"}) {
        OCL::FileReporting files("Files");
        peer(files, name);
        EXPECT_FALSE(files.screenComponent(name)) << name;
        EXPECT_THAT(log(), HasSubstr("could not screen component '" + std::string(name) + "': a name with a '/'"));
    }
    EXPECT_EQ((std::vector<std::string>{"inner", "inner/here"}), files());
    OCL::FileReporting files("Files");
    peer(files, "..");
    EXPECT_TRUE(files.screenComponent(".."));
    EXPECT_EQ((std::vector<std::string>{"inner", "inner/...screen", "inner/here"}), this->files());
}

TEST_F(ReportNames, ScreensOfNamesWithControlCharactersAreRefused) {
    for (const char* name : kForging) {
        OCL::FileReporting files("Files");
        peer(files, name);
        EXPECT_FALSE(files.screenComponent(name));
        peer(*reporter, name);
        EXPECT_FALSE(reporter->screenComponent(name));
    }
    EXPECT_EQ("", text.str());
    EXPECT_EQ((std::vector<std::string>{"inner", "inner/here"}), files());
}

TEST_F(ReportNames, NothingOfAComponentWhoseNameHasControlCharactersIsReported) {
    double gain = 1;
    for (const char* name : kForging) {
        peer(*reporter, name);
        named_->addProperty("gain", gain);
        EXPECT_FALSE(reporter->reportComponent(name));
        EXPECT_FALSE(reporter->reportPort(name, "port"));
        EXPECT_FALSE(reporter->reportData(name, "gain"));
    }
    EXPECT_FALSE(reporter->unreportComponent(kForging[0]));
    ASSERT_TRUE(reporter->reportPort("Machine", "speed"));
    ASSERT_TRUE(reporter->start());
    EXPECT_EQ(" TimeStamp Machine.speed\n 0 0 \n", report());
}

TEST_F(ReportNames, APathIsAColumnAsAnyOtherName) {
    peer(*reporter, "../x");
    ASSERT_TRUE(reporter->reportComponent("../x"));
    ASSERT_TRUE(reporter->start());
    EXPECT_THAT(report(), HasSubstr(" TimeStamp ../x.port\n"));
    EXPECT_EQ((std::vector<std::string>{"inner", "inner/here"}), files());
}

}  // namespace
