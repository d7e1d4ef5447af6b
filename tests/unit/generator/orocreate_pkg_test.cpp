// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What orocreate-pkg does to a directory; the texts it writes are goldens.
#include <algorithm>

#include <gtest/gtest.h>
#include <support/child_process.hpp>
#include <support/golden.hpp>
#include <support/temp_dir.hpp>

namespace fs = std::filesystem;

namespace oroforge {
namespace {

constexpr const char* kManifest =
    "<package name=\"tank\"><component class=\"tank::Controller\">"
    "<port name=\"level\" direction=\"in\" type=\"double\"/></component></package>\n";

class OrocreatePkg : public testing::Test {
protected:
    test::Outcome run(std::vector<std::string> arguments) {
        test::Command command;
        command.program = OROCREATE_PKG;
        command.arguments = std::move(arguments);
        command.directory = dir_.path();
        return test::run(command);
    }
    std::string read(const std::string& name) const { return test::readFile(dir_ / name); }

    test::TempDir dir_;
};

TEST_F(OrocreatePkg, HelpAndVersionSucceed) {
    EXPECT_EQ(run({"-h"}).status, 0);
    EXPECT_NE(run({"--help"}).out.find("--from"), std::string::npos);
    EXPECT_EQ(run({"--version"}).status, 0);
}

TEST_F(OrocreatePkg, ExplainsItsCodes) {
    const test::Outcome one = run({"--explain", "om051", "OC004"});
    EXPECT_EQ(one.status, 0) << one.err;
    EXPECT_EQ(one.out.rfind("OM051: a buffer without a size\n\n", 0), 0U) << one.out;
    EXPECT_NE(one.out.find("\nOC004: a folder that exists already\n"), std::string::npos) << one.out;
    EXPECT_NE(run({"--explain"}).out.find("OM010  a name that is no identifier\n"), std::string::npos);
    const test::Outcome unknown = run({"--explain", "OM151"});
    EXPECT_EQ(unknown.status, 1);
    EXPECT_NE(unknown.err.find("[OC001] no diagnostic has the code 'OM151'"), std::string::npos) << unknown.err;
    EXPECT_EQ(run({"--explain", "OM051", "--generate", "m.xml"}).status, 1);
}

TEST_F(OrocreatePkg, RefusesAnExistingDirectory) {
    fs::create_directory(dir_ / "mypkg");

    const auto outcome = run({"mypkg", "component"});

    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find("[OC004]"), std::string::npos);
    EXPECT_TRUE(fs::is_empty(dir_ / "mypkg"));
}

TEST_F(OrocreatePkg, ForceKeepsUserFilesAndEarlierKinds) {
    ASSERT_EQ(run({"mypkg", "component"}).status, 0);
    dir_.write("mypkg/src/mypkg-component.cpp", "mine");

    const auto outcome = run({"mypkg", "service", "-f"});

    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(read("mypkg/src/mypkg-component.cpp"), "mine");
    const std::string cmake = read("mypkg/CMakeLists.txt");
    EXPECT_NE(cmake.find("orocos_component(mypkg src/mypkg-component.cpp)"), std::string::npos);
    EXPECT_NE(cmake.find("orocos_service(mypkg-service"), std::string::npos);
}

TEST_F(OrocreatePkg, NamesThatNoBuildCanUseAreRefused) {
    for (const char* name : {"switch", "test", "install"}) {
        const auto outcome = run({name, "component"});
        EXPECT_EQ(outcome.status, 1) << name;
        EXPECT_NE(outcome.err.find("[OC002]"), std::string::npos) << outcome.err;
        EXPECT_FALSE(fs::exists(dir_ / name));
    }
}

TEST_F(OrocreatePkg, ForceKeepsEveryVersionOfABuildFile) {
    ASSERT_EQ(run({"mypkg", "component"}).status, 0);
    dir_.write("mypkg/CMakeLists.txt", "mine");
    ASSERT_EQ(run({"mypkg", "service", "-f"}).status, 0);
    dir_.write("mypkg/CMakeLists.txt", "mine again");

    const auto outcome = run({"mypkg", "service", "-f"});

    EXPECT_EQ(read("mypkg/CMakeLists.txt.old"), "mine");
    EXPECT_EQ(read("mypkg/CMakeLists.txt.old2"), "mine again");
    EXPECT_NE(outcome.out.find("wrote mypkg/CMakeLists.txt.old2"), std::string::npos) << outcome.out;
    EXPECT_FALSE(fs::exists(dir_ / "mypkg/README.md.old2"));
}

TEST_F(OrocreatePkg, GenerationDoesNotReplaceAFileOfTheUser) {
    dir_.write("tank.xml", kManifest);
    dir_.write("gen/tank/registration.cpp", "mine");
    const auto outcome = run({"--generate", "tank.xml", "--output", "gen"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(read("gen/tank/registration.cpp"), "mine");
    EXPECT_FALSE(fs::exists(dir_ / "gen/tank/ControllerBase.hpp"));
    EXPECT_NE(outcome.err.find("gen/tank/registration.cpp: error: [EMIT002]"), std::string::npos) << outcome.err;
}

TEST_F(OrocreatePkg, EmptyMakesOnlyThePackageFile) {
    ASSERT_EQ(run({"mypkg", "empty"}).status, 0);

    EXPECT_EQ(test::readTree(dir_ / "mypkg").size(), 1U);
    EXPECT_TRUE(fs::exists(dir_ / "mypkg/package.xml"));
}

TEST_F(OrocreatePkg, CmakeMakesNoSources) {
    ASSERT_EQ(run({"mypkg", "cmake"}).status, 0);

    EXPECT_TRUE(fs::exists(dir_ / "mypkg/CMakeLists.txt"));
    EXPECT_FALSE(fs::exists(dir_ / "mypkg/src"));
}

TEST_F(OrocreatePkg, TakesHeadersAlongThatStandBesideTheManifest) {
    dir_.write("in/include/tank/types.hpp", "// mine\n");
    dir_.write("in/m.xml", "<package name=\"tank\"><typekit header=\"include/tank/types.hpp\"/></package>");

    ASSERT_EQ(run({"tank", "--from", "in/m.xml"}).status, 0);

    EXPECT_EQ(read("tank/include/tank/types.hpp"), "// mine\n");
}

TEST_F(OrocreatePkg, GenerateWritesWhatListOutputsSays) {
    dir_.write("tank.xml", kManifest);

    const auto listed = run({"--generate", "tank.xml", "--output", "gen", "--list-outputs"});
    EXPECT_FALSE(fs::exists(dir_ / "gen"));
    const auto made = run({"--generate", "tank.xml", "--output", "gen", "--depfile", "gen.d"});

    EXPECT_EQ(made.status, 0);
    EXPECT_EQ(made.out + made.err, "");
    std::string files;
    for (const auto& file : test::readTree(dir_ / "gen")) files += "gen/" + file.first + "\n";
    EXPECT_EQ(listed.out, files);
    EXPECT_NE(read("gen.d").find("gen/tank/ControllerBase.hpp"), std::string::npos);
    EXPECT_NE(read("gen.d").find((dir_ / "tank.xml").string()), std::string::npos);
}

TEST_F(OrocreatePkg, DepfileIsAboutAnotherFileOnRequest) {
    dir_.write("tank.xml", kManifest);
    const auto made =
        run({"--generate", "tank.xml", "--output", "gen", "--depfile", "gen.d", "--depfile-target", "a stamp"});
    EXPECT_EQ(made.status, 0) << made.err;
    EXPECT_EQ(read("gen.d").compare(0, 10, "a\\ stamp: "), 0) << read("gen.d");
}

TEST_F(OrocreatePkg, DepfileNamesTheHeadersInWhichTypesWereLookedUp) {
    dir_.write("tank.xml",
               "<package name=\"tank\"><typekit header=\"include/tank/types.hpp\"/><component class=\"tank::A\">"
               "<port name=\"p\" direction=\"in\" type=\"tank::Level\"/></component></package>\n");
    const auto header = dir_.write("include/tank/types.hpp", "#pragma once\nnamespace tank { struct Level {}; }\n");
    const auto made = run({"--generate", "tank.xml", "--output", "gen", "--depfile", "gen.d"});
    EXPECT_EQ(made.status, 0) << made.err;
    EXPECT_NE(read("gen.d").find(header.string()), std::string::npos) << read("gen.d");
}

TEST_F(OrocreatePkg, SecondGenerationTouchesNothing) {
    dir_.write("tank.xml", kManifest);
    ASSERT_EQ(run({"--generate", "tank.xml", "--output", "gen"}).status, 0);
    const fs::path file = dir_ / "gen/tank/ControllerBase.hpp";
    const auto old = fs::last_write_time(file) - std::chrono::hours(1);
    fs::last_write_time(file, old);

    ASSERT_EQ(run({"--generate", "tank.xml", "--output", "gen"}).status, 0);

    EXPECT_EQ(fs::last_write_time(file), old);
}

TEST_F(OrocreatePkg, TemplateDirReplacesTemplates) {
    dir_.write("t/package/README.md.mustache", "about {{name}}\n");
    dir_.write("bad/package/README.md.mustache", "about {{nmae}}\n");

    EXPECT_EQ(run({"a", "cmake", "--template-dir", "t"}).status, 0);
    EXPECT_EQ(read("a/README.md"), "about a\n");
    const auto outcome = run({"b", "cmake", "--template-dir", "bad"});
    EXPECT_EQ(outcome.err, "orocreate-pkg: error: [OC007] template package/README.md: no key 'nmae' in the view\n");
    EXPECT_FALSE(fs::exists(dir_ / "b"));
}

TEST_F(OrocreatePkg, UnwritableDirectoryIsReported) {
    dir_.write("gen", "a file in the way");
    dir_.write("tank.xml", kManifest);

    const auto outcome = run({"--generate", "tank.xml", "--output", "gen"});

    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find("[EMIT001]"), std::string::npos);
}

TEST_F(OrocreatePkg, NamesThatAreTooLongAreReported) {
    const std::string name(300, 'x');
    dir_.write("long.xml", "<package name=\"" + name + "\"/>");

    for (const std::vector<std::string>& words :
         {std::vector<std::string>{name}, {name, "component"}, {"--from", "long.xml"}, {name, "-f"}}) {
        const auto outcome = run(words);
        EXPECT_EQ(outcome.status, 1) << words.back();
        EXPECT_NE(outcome.err.find("error: [EMIT001] cannot make the directory: File name too long"), std::string::npos)
            << outcome.err;
    }
    EXPECT_EQ(test::readTree(dir_.path()).size(), 1U);
}

TEST_F(OrocreatePkg, NothingThatTheSystemRefusesAborts) {
    const std::string name(300, 'x');
    dir_.write("a.cpp", "int i;\n");
    ASSERT_EQ(run({"pkg", "cmake"}).status, 0);
    fs::create_directory(dir_ / "closed");
    fs::create_directory_symlink("loop", dir_ / "loop");

    for (const std::vector<std::string>& words : {std::vector<std::string>{"--describe", ""},
                                                  {"--describe", name},
                                                  {"--describe", "a.cpp", "--package", "a", "-o", name},
                                                  {"--describe", "a.cpp", "-p", name},
                                                  {"--generate", name, "-o", "x"},
                                                  {"--update", name},
                                                  {"--update", "loop/m.xml"},
                                                  {"--upgrade", name},
                                                  {"--upgrade", "loop"},
                                                  {"pkg2", "--template-dir", name},
                                                  {"pkg2", "--template-dir", "loop"},
                                                  {"pkg2", "--from", name}}) {
        const auto outcome = run(words);
        EXPECT_EQ(outcome.status, 1) << words.front() << ": " << outcome.err;
        EXPECT_NE(outcome.err.find("error: ["), std::string::npos) << words.front() << ": " << outcome.err;
    }
}

TEST_F(OrocreatePkg, AWorkingFolderThatIsGoneIsReported) {
    test::Command command;
    command.program = "/bin/sh";
    command.directory = dir_.path();
    for (const char* words : {"pkg", "--update", "--add component x", "--upgrade .", "--describe a.cpp"}) {
        command.arguments = {"-c", "mkdir gone; cd gone; rmdir ../gone; exec \"$0\" " + std::string(words),
                             OROCREATE_PKG};
        const auto outcome = test::run(command);
        EXPECT_EQ(outcome.status, 1) << words << ": " << outcome.err;
        EXPECT_NE(outcome.err.find("error: ["), std::string::npos) << words << ": " << outcome.err;
    }
}

TEST_F(OrocreatePkg, OutputThatDoesNotArriveIsAFailure) {
    dir_.write("tank.xml", kManifest);
    test::Command command;
    command.program = "/bin/sh";
    command.directory = dir_.path();
    for (const char* words :
         {"--list", "--explain", "--explain OC001", "--help", "--version", "pkg cmake", "pkg2 cmake --format json",
          "--generate tank.xml --dump view", "--generate tank.xml -o gen --list-outputs"}) {
        command.arguments = {"-c", "exec \"$0\" " + std::string(words) + " > /dev/full", OROCREATE_PKG};
        const auto outcome = test::run(command);
        EXPECT_EQ(outcome.status, 1) << words;
        const std::string told =
            "orocreate-pkg: error: [EMIT004] cannot write to standard output: No space left on device\n";
        EXPECT_EQ(outcome.err.substr(outcome.err.size() - std::min(outcome.err.size(), told.size())), told) << words;
    }
}

TEST_F(OrocreatePkg, LinksPlantedForItsProcessAreNotFollowed) {
    dir_.write("tank.xml", kManifest);
    dir_.write("victim", "mine");
    test::Command command;
    command.program = "/bin/sh";
    command.directory = dir_.path();
    command.arguments = {"-c",
                         "mkdir -p gen/tank; for f in ControllerBase.hpp ControllerBase.cpp; do\n"
                         "ln -s ../../victim gen/tank/$f.new$$; ln -s ../../victim gen/tank/$f.$$.0.new; done\n"
                         "exec \"$0\" --generate tank.xml -o gen",
                         OROCREATE_PKG};
    const auto outcome = test::run(command);

    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(read("victim"), "mine");
}

}  // namespace
}  // namespace oroforge
