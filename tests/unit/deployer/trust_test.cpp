// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Whose code the deployer executes: what nobody asked for is not looked for in the current folder, and libraries that others can
// put there or change are refused.
#include "deployer_program.hpp"

#include <gmock/gmock.h>

#include <filesystem>

#include <sys/stat.h>
#include <unistd.h>

namespace {

using namespace oroforge::test;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

const std::string kLibrary = "libdeploytest-" OROCOS_TARGET_WORD ".so";
constexpr uid_t kStranger = 65534;

class Trust : public deployer_test::DeployerInDirectory {
protected:
    fs::path copyTo(const std::string& folder) {
        fs::create_directories(directory_ / folder);
        const fs::path file = directory_ / folder / kLibrary;
        fs::copy_file(fs::path(DEPLOYER_TEST_PATH) / OROCOS_TARGET_WORD / "deploytest" / kLibrary, file);
        chmod(file.c_str(), 0755);
        chmod(fs::path(directory_ / folder).c_str(), 0755);
        return file;
    }

    /** Without a terminal, with this in its console. */
    Outcome type(const std::string& input, const std::string& path = "", const std::string& owners = "") {
        Command deployer = command({});
        deployer.input = input;
        deployer.environment["RTT_COMPONENT_PATH"] = path;
        deployer.environment["ORO_TRUSTED_OWNERS"] = owners;
        deployer.environment["SUDO_UID"] = "";
        return run(deployer);
    }

    void expectRefused(const std::string& why) {
        const Outcome outcome = type("import(\"mine\")\ndisplayComponentTypes()\n");
        EXPECT_THAT(outcome.out + outcome.err, HasSubstr(kLibrary + ": it is not trusted: " + why));
        EXPECT_THAT(outcome.out, Not(HasSubstr("deploytest::Producer")));
    }

    void expectAccepted(const std::string& owners = "") {
        const Outcome outcome = type("import(\"mine\")\ndisplayComponentTypes()\n", "", owners);
        EXPECT_THAT(outcome.out, HasSubstr("deploytest::Producer")) << outcome.err;
    }
};

TEST_F(Trust, ImplicitImportTakesTheInstalledPackage) {
    copyTo("ocl");
    for (const std::string input : {"", "import(\"ocl\")\n"}) {
        const Outcome outcome = type(input + "displayComponentTypes()\n");
        EXPECT_THAT(outcome.out, HasSubstr("OCL::HelloWorld")) << outcome.err;
        EXPECT_THAT(outcome.out, Not(HasSubstr("deploytest::Producer")));
    }
}

TEST_F(Trust, ImplicitImportTakesNoFileOfTheName) {
    fs::rename(copyTo("folder"), directory_ / "ocl");
    const Outcome outcome = type("displayComponentTypes()\n");
    EXPECT_THAT(outcome.out, HasSubstr("OCL::HelloWorld")) << outcome.err;
    EXPECT_THAT(outcome.out, Not(HasSubstr("deploytest::Producer")));
}

TEST_F(Trust, OwnLibraryIsImportedFromHere) {
    copyTo("mine");
    expectAccepted();
}

TEST_F(Trust, LibraryThatOthersCanWriteIsRefused) {
    chmod(copyTo("mine").c_str(), 0757);
    expectRefused("other users can write to it");
}

TEST_F(Trust, LibraryInAFolderOfEverybodyIsRefused) {
    copyTo("mine");
    for (const mode_t mode : {0777, 01777}) {
        chmod(fs::path(directory_ / "mine").c_str(), mode);
        expectRefused("other users can write to its folder ");
    }
}

TEST_F(Trust, FolderThatOthersCanReplaceIsRefused) {
    copyTo("above/mine");
    fs::create_directory_symlink("above/mine", directory_ / "mine");
    chmod(fs::path(directory_ / "above").c_str(), 0777);
    expectRefused("other users can put another folder in the place of ");
    chmod(fs::path(directory_ / "above").c_str(), 01777);  // as in /tmp: only the owner can move it
    expectAccepted();
}

TEST_F(Trust, LibraryOfAnotherOwnerIsRefused) {
    if (geteuid() != 0) GTEST_SKIP() << "only root can give files away";
    const fs::path file = copyTo("mine");
    ASSERT_EQ(0, chown(file.c_str(), kStranger, 0));
    expectRefused("it belongs to ");
    expectAccepted("root:" + std::to_string(kStranger));
    ASSERT_EQ(0, chown(file.c_str(), 0, 0));
    ASSERT_EQ(0, chown(fs::path(directory_ / "mine").c_str(), kStranger, 0));
    expectRefused("its folder ");
}

TEST_F(Trust, PluginsOfOthersAreRefused) {
    const fs::path file = copyTo("plugins");
    chmod(fs::path(directory_ / "plugins").c_str(), 0777);
    const Outcome outcome = type("", directory_.path().string());
    EXPECT_THAT(outcome.err, HasSubstr(kLibrary + ": it is not trusted: other users can write to its folder"));
}

class WrapperTrust : public Trust {
protected:
    /** The wrapper below the folder with the list: what it warns of, and whether it took the list. */
    Outcome start() {
        fs::create_directories(directory_ / "here");
        fs::copy_file(DEPLOYER_WRAPPER, directory_ / "greet", fs::copy_options::overwrite_existing);
        directory_.write("greet-one", "#!/bin/sh\necho \"[$RTT_COMPONENT_PATH]\"\n");
        fs::permissions(directory_ / "greet-one", fs::perms::owner_all);
        Command wrapper = command({});
        wrapper.program = (directory_ / "greet").string();
        wrapper.directory = directory_ / "here";
        wrapper.environment = {
            {"OROCOS_TARGET", "one"}, {"RTT_COMPONENT_PATH", ""}, {"ORO_TRUSTED_OWNERS", ""}, {"SUDO_UID", ""}};
        return run(wrapper);
    }

    void expectTaken() { EXPECT_EQ("[:" + (directory_ / "libs").string() + "]\n", start().out); }
    void expectNotTaken(const std::string& why) {
        const Outcome outcome = start();
        EXPECT_EQ("[]\n", outcome.out);
        EXPECT_THAT(outcome.err, HasSubstr("greet: warning: " + list_.string() + " is not used: " + why));
        EXPECT_EQ(0, outcome.status);
    }

    const fs::path list_ = directory_.write(".rtt_component_path", "libs\n");
};

TEST_F(WrapperTrust, OwnListIsTaken) { expectTaken(); }

TEST_F(WrapperTrust, ListThatOthersCanWriteIsNotTaken) {
    chmod(list_.c_str(), 0646);
    expectNotTaken("other users can write to " + list_.string());
}

TEST_F(WrapperTrust, ListInAFolderOfEverybodyIsNotTaken) {
    for (const mode_t mode : {0777, 01777}) {
        chmod(directory_.path().c_str(), mode);
        expectNotTaken("other users can write to " + directory_.path().string());
    }
}

TEST_F(WrapperTrust, ListOfAnotherOwnerIsNotTaken) {
    if (geteuid() != 0) GTEST_SKIP() << "only root can give files away";
    ASSERT_EQ(0, chown(list_.c_str(), kStranger, 0));
    expectNotTaken(list_.string() + " belongs to ");
}

}  // namespace
