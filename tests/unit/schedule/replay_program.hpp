// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_REPLAY_PROGRAM_HPP
#define OROFORGE_TESTS_REPLAY_PROGRAM_HPP

#include <support/child_process.hpp>
#include <support/temp_dir.hpp>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace replay_test {

/** The deployer in a directory that has a recording, run.mcap, of a camera and a viewer, and their deployment. */
class ReplayInDirectory : public testing::Test {
protected:
    static void SetUpTestSuite();
    void SetUp() override;

    /** Its packages: "recorded" has the camera, "runs" what runs in a replay, "types" the type of poses. */
    oroforge::test::Command command(const std::vector<std::string>& words,
                                    const std::vector<std::string>& packages = {"runs", "types"}) const;
    /** Replays run.mcap with these words more. */
    oroforge::test::Outcome replay(std::vector<std::string> words,
                                   const std::vector<std::string>& packages = {"runs", "types"}) const;
    std::string bytes(const std::string& file) const { return oroforge::test::readFile(directory_ / file); }
    std::string log() const { return bytes("orocos.log"); }

    oroforge::test::TempDir directory_;

private:
    static std::string recording_;
};

/** A deployment of these components, after the imports. */
std::string deployment(const std::string& components);
/** A component that is started, with these parts. */
std::string component(const std::string& name, const std::string& type, const std::string& parts = "");

extern const char* const kCamera;
extern const char* const kViewer;

}  // namespace replay_test

#endif
