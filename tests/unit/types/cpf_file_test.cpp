// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// How property files are replaced.
#include "cpf_fixture.hpp"

#include <cpf/property_file.hpp>
#include <cpf/replace_file.hpp>
#include <rtt/marsh/PropertyMarshaller.hpp>

#include <grp.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/wait.h>

using namespace RTT;
using namespace RTT::marsh;
using namespace types_test;

namespace fs = std::filesystem;

namespace {

/** What `action` returns in a process of its own. */
template <class Action>
int inChild(Action action) {
    const pid_t child = fork();
    if (child == 0) _exit(action());
    int status = 0;
    EXPECT_EQ(child, waitpid(child, &status, 0));
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

class CpfFile : public Cpf {
protected:
    /** How many files there are; what is written beside a file must go away. */
    long filesIn(const fs::path& where) const {
        return std::distance(fs::directory_iterator(where), fs::directory_iterator());
    }
    struct stat status() const {
        struct stat result {};
        EXPECT_EQ(0, ::stat(file.c_str(), &result));
        return result;
    }
    /** A file of root that the group and others may write to, in a folder that has `folderMode`. */
    void putShared(mode_t mode, mode_t folderMode) const {
        putText("one");
        EXPECT_EQ(0, ::chown(file.c_str(), 0, ourGroup));
        EXPECT_EQ(0, ::chmod(file.c_str(), mode));
        EXPECT_EQ(0, ::chmod(folder.c_str(), folderMode));
    }

    /** The error of replaceFile() by a user of another group, who is a member of `ourGroup` besides. */
    int replaceAsMember() const {
        return inChild([this] {
            const gid_t groups[] = {ourGroup};
            const bool possible = setgroups(1, groups) == 0 && setgid(54321) == 0 && setuid(54321) == 0;
            return possible ? replaceFile(file, "two").value() : notPossible;
        });
    }

    static constexpr gid_t ourGroup = 12345;
    static constexpr int notPossible = 200;  // no number of an error
};

}  // namespace

TEST_F(CpfFile, NewAndOldFilesGetTheText) {
    EXPECT_FALSE(replaceFile(file, "one"));
    EXPECT_EQ("one", get());
    EXPECT_FALSE(replaceFile(file, ""));
    EXPECT_EQ("", get());
    EXPECT_EQ(1, filesIn(folder));
}

TEST_F(CpfFile, PermissionsStay) {
    putText("one");
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write | fs::perms::others_exec);
    const auto before = fs::status(file).permissions();
    ASSERT_FALSE(replaceFile(file, "two"));
    EXPECT_EQ(before, fs::status(file).permissions());
}

TEST_F(CpfFile, TheGroupStaysIfTheOwnerCannot) {
    if (geteuid() != 0) GTEST_SKIP() << "needs a file of another user";
    putShared(0664, 0777);
    const int result = replaceAsMember();
    if (result == notPossible) GTEST_SKIP() << "cannot become another user";
    EXPECT_EQ(0, result);
    EXPECT_EQ("two", get());
    EXPECT_EQ(ourGroup, status().st_gid);
    EXPECT_EQ(static_cast<mode_t>(0664), status().st_mode & 07777);
}

TEST_F(CpfFile, FilesOfOthersInStickyFoldersAreWrittenTo) {
    if (geteuid() != 0) GTEST_SKIP() << "needs a file of another user";
    putShared(0664, 01777);
    const int result = replaceAsMember();
    if (result == notPossible) GTEST_SKIP() << "cannot become another user";
    EXPECT_EQ(0, result);
    EXPECT_EQ("two", get());
    EXPECT_EQ(0u, status().st_uid);
    EXPECT_EQ(1, filesIn(folder));
}

TEST_F(CpfFile, MountPointsAreWrittenTo) {
    putText("one");
    fs::create_directory(folder / "d");
    const std::string mounted = (folder / "d" / "mounted.cpf").string();
    std::ofstream(mounted) << "below the mount";
    const int result = inChild([&] {
        const bool possible = unshare(CLONE_NEWNS) == 0 &&
                              mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
                              mount(file.c_str(), mounted.c_str(), nullptr, MS_BIND, nullptr) == 0;
        return possible ? replaceFile(mounted, "two").value() : notPossible;
    });
    if (result == notPossible) GTEST_SKIP() << "cannot mount";
    EXPECT_EQ(0, result);
    EXPECT_EQ("two", get());
    EXPECT_EQ(1, filesIn(folder / "d"));
}

TEST_F(CpfFile, NewFilesHaveTheUsualPermissions) {
    putText("made by a stream");
    const std::string other = (folder / "other.cpf").string();
    ASSERT_FALSE(replaceFile(other, "x"));
    EXPECT_EQ(fs::status(file).permissions(), fs::status(other).permissions());
}

TEST_F(CpfFile, LinksStayLinks) {
    fs::create_directory(folder / "d");
    fs::create_symlink("d/real.cpf", folder / "link.cpf");
    fs::create_symlink("link.cpf", file);
    for (const char* text : {"into nothing", "into a file"}) {
        ASSERT_FALSE(replaceFile(file, text));
        EXPECT_TRUE(fs::is_symlink(file));
        EXPECT_TRUE(fs::is_symlink(folder / "link.cpf"));
        EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(folder / "d" / "real.cpf")));
        EXPECT_EQ(text, get());
    }
}

TEST_F(CpfFile, FoldersAndMissingFoldersAreErrors) {
    EXPECT_EQ(std::errc::is_a_directory, replaceFile(folder.string(), "x"));
    EXPECT_EQ(std::errc::no_such_file_or_directory, replaceFile((folder / "no" / "f").string(), "x"));
    fs::create_symlink(file, file);
    EXPECT_TRUE(replaceFile(file, "x")) << "a link to itself";
    EXPECT_EQ(1, filesIn(folder));
}

TEST_F(CpfFile, DevicesAreWrittenTo) {
    EXPECT_FALSE(replaceFile("/dev/null", "x"));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    EXPECT_EQ(std::errc::no_space_on_device, replaceFile("/dev/full", "x"));
}

namespace {

/** What stood in the file when the disk was waited for, and how long the text was that was written by then. */
std::string watchedFile, atSync;
off_t sizeAtSync = -1;

}  // namespace

/** Instead of the C library's. */
extern "C" int fsync(int descriptor) {
    struct stat is {};
    sizeAtSync = ::fstat(descriptor, &is) == 0 ? is.st_size : -1;
    std::ifstream in(watchedFile);
    std::getline(in, atSync, '\0');
    return 0;
}

TEST_F(CpfFile, TheDiskIsWaitedForBeforeTheFileIsReplaced) {
    putText("old");
    watchedFile = file;
    sizeAtSync = -1;
    ASSERT_FALSE(replaceFile(file, "new text"));
    EXPECT_EQ("old", atSync);
    EXPECT_EQ(8, sizeAtSync);
    EXPECT_EQ("new text", get());

    sizeAtSync = -1;
    ASSERT_TRUE(saveToFile(bag, file, SaveMode::store, sink));
    EXPECT_LT(0, sizeAtSync);
    sizeAtSync = -1;
    PropertyMarshaller marshaller(file);
    marshaller.serialize(bag);
    marshaller.flush();
    EXPECT_LT(0, sizeAtSync);
}

TEST_F(CpfFile, WhatDeadProcessesLeftIsRemoved) {
    const pid_t dead = fork();
    if (dead == 0) _exit(0);
    ASSERT_EQ(dead, waitpid(dead, nullptr, 0));
    std::ofstream(file + "." + std::to_string(dead) + ".7.new") << "<?xml";
    std::ofstream(file + "." + std::to_string(getppid()) + ".7.new") << "<?xml";
    ASSERT_FALSE(replaceFile(file, "x"));
    EXPECT_EQ(2, filesIn(folder)) << "only the one of a process that lives may stay";
}

TEST_F(CpfFile, LinksThatWerePlantedAreNotFollowed) {
    const std::string victim = (folder / "victim").string();
    std::ofstream(victim) << "mine";
    for (int i = 0; i != 60; ++i)
        fs::create_symlink(victim, file + "." + std::to_string(getpid()) + "." + std::to_string(i) + ".new");
    ASSERT_FALSE(replaceFile(file, "x"));
    std::string text;
    std::getline(std::ifstream(victim), text);
    EXPECT_EQ("mine", text);
}

TEST_F(CpfFile, ReadOnlyFilesAreRefused) {
    if (geteuid() == 0) GTEST_SKIP() << "root may write to all files";
    putText("one");
    fs::permissions(file, fs::perms::owner_read);
    EXPECT_EQ(std::errc::permission_denied, replaceFile(file, "two"));
    EXPECT_EQ("one", get());
}

TEST_F(CpfFile, ErrorsNameTheFileAndTheReason) {
    fs::create_directory(file);
    EXPECT_FALSE(saveToFile(bag, file, SaveMode::store, sink));
    EXPECT_EQ("test.cpf: error: [CPF030] cannot write the file: Is a directory\n", said());
    EXPECT_FALSE(saveToFile(bag, file, SaveMode::merge, sink));
    EXPECT_FALSE(loadFromFile(bag, file, LoadMode::load, sink));
    EXPECT_EQ(2u, sink.sorted().size()) << said();
}
