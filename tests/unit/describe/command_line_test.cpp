// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Where --describe takes the compiler's options from.
#include <clang/base/toolchain_flags.hpp>
#include <driver/compiler_words.hpp>
#include <support/child_process.hpp>
#include <support/temp_dir.hpp>

#include <gtest/gtest.h>

namespace fs = std::filesystem;

namespace oroforge::test {
namespace {

using Words = std::vector<std::string>;

TEST(CompilerWords, AreTakenOutOfTheCommandLine) {
    Words words = {"--describe", "-Iinclude", "a.hpp", "-isystem", "/x",  "-DA=1", "-D", "B",
                   "-std=c++20", "-o",        "m.xml", "-include", "c.h", "-UC",   "--", "-Inot"};

    const Words taken = driver::takeCompilerWords(words);

    EXPECT_EQ(taken, (Words{"-I", "include", "-isystem", "/x", "-D", "A=1", "-D", "B", "-std=c++20", "-include", "c.h",
                            "-U", "C"}));
    EXPECT_EQ(words, (Words{"--describe", "a.hpp", "-o", "m.xml", "--", "-Inot"}));
}

TEST(CompilerWords, WithoutTheirValueStayToBeRefused) {
    Words words = {"--describe", "-I"};

    EXPECT_TRUE(driver::takeCompilerWords(words).empty());
    EXPECT_EQ(words, (Words{"--describe", "-I"}));
}

TEST(ToolchainFlags, AreThoseOfTheInstallationThatTheProgramIsIn) {
    const TempDir dir;
    const fs::path program = dir.write("prefix/bin/orocreate-pkg", "");
    dir.write("prefix/include/orocos/rtt/TaskContext.hpp", "");
    fs::create_symlink(program, dir.path() / "link");
    const std::string include = (fs::canonical(dir.path()) / "prefix/include").string();

    EXPECT_EQ(cxx::toolchainFlags(program.string()), (Words{"-isystem", include, "-isystem", include + "/orocos"}));
    EXPECT_EQ(cxx::toolchainFlags((dir.path() / "link").string()), cxx::toolchainFlags(program.string()));
}

TEST(ToolchainFlags, AreTheSourcesOfABuildTree) {
    const TempDir dir;
    const fs::path program = dir.write("build/bin/orocreate-pkg", "");
    dir.write("source/runtime/rtt/TaskContext.hpp", "");
    dir.write("build/include/rtt/rtt-config.h", "");
    const fs::path root = fs::canonical(dir.path());
    dir.write("build/CMakeCache.txt", "A:B=C\nCMAKE_HOME_DIRECTORY:INTERNAL=" + (root / "source").string() + "\n");

    EXPECT_EQ(cxx::toolchainFlags(program.string()),
              (Words{"-isystem", (root / "source/runtime").string(), "-isystem", (root / "build/include").string()}));
}

TEST(ToolchainFlags, AreNoneOfAProgramThatStandsAlone) {
    const TempDir dir;
    EXPECT_TRUE(cxx::toolchainFlags(dir.write("bin/orocreate-pkg", "").string()).empty());
}

/// A package as others have it, with what its build knows in a compile database.
TEST(DescribeProcess, ReadsAPackageWithTheOptionsOfItsBuild) {
    const TempDir dir;
    dir.write(
        "arm/include/arm/arm.hpp",
        "#pragma once\n#include <rtt/TaskContext.hpp>\n#include <limits.hpp>\nclass Arm : public RTT::TaskContext {\n"
        "public:\n    explicit Arm(const std::string& name);\n    int joints_ = JOINTS;\n    double most_ = "
        "kMost;\n};\n");
    dir.write("arm/src/arm.cpp",
              "#include <arm/arm.hpp>\nArm::Arm(const std::string& name) : TaskContext(name) {\n"
              "    addProperty(\"joints\", joints_);\n    addProperty(\"most\", most_);\n}\n");
    dir.write("elsewhere/limits.hpp", "#pragma once\nconstexpr double kMost = 1.5;\n");
    dir.write("build/compile_commands.json", "[{\"directory\": \"" + dir.path().string() +
                                                 "\", \"file\": \"arm/src/arm.cpp\", \"command\": "
                                                 "\"c++ -Ielsewhere -DJOINTS=6 -c arm/src/arm.cpp\"}]");
    Command command;
    command.program = OROCREATE_PKG;
    command.directory = dir.path();
    command.arguments = {"--describe", "arm/include/arm/arm.hpp", "-p", "build"};

    const Outcome outcome = run(command);

    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(
        outcome.out,
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<package name=\"arm\">\n  <component class=\"Arm\">\n"
        "    <property name=\"joints\" type=\"int\" default=\"6\"/>\n"
        "    <property name=\"most\" type=\"double\" default=\"1.5\"/>\n    <hooks/>\n  </component>\n</package>\n");

    command.arguments = {"--describe", "arm/include/arm/arm.hpp", "-p", "build", "-DJOINTS=7"};
    EXPECT_NE(run(command).out.find("default=\"7\""), std::string::npos);
}

}  // namespace
}  // namespace oroforge::test
