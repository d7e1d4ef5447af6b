// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// typegen from the command line, with no option of the compiler.
#include <clang/base/missing_header.hpp>
#include <support/child_process.hpp>
#include <support/temp_dir.hpp>

#include <gtest/gtest.h>

namespace fs = std::filesystem;

namespace oroforge::test {
namespace {

Outcome typegen(const fs::path& program, const fs::path& folder, std::vector<std::string> words) {
    Command command;
    command.program = program;
    command.directory = folder;
    command.arguments = std::move(words);
    return run(command);
}

std::string useOf(const std::string& header) {
    return "#pragma once\n#include <" + header + ">\nnamespace demo { struct A { RTT::Thing thing; }; }\n";
}

}  // namespace

TEST(OwnPrefix, HeadersOfABuildTreeAreFound) {
    const TempDir dir;
    dir.write("types.hpp",
              "#pragma once\n#include <rtt/ConnPolicy.hpp>\n#include <rtt/rtt-config.h>\nstruct A { int a; };\n");
    const Outcome outcome = typegen(TYPEGEN, dir.path(), {"-o", "out", "demo", "types.hpp"});
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.status, 0);
}

TEST(OwnPrefix, HeadersOfAMovedInstallationAreFound) {
    const TempDir dir;
    dir.write("first/include/orocos/rtt/TaskContext.hpp", "");
    dir.write("first/include/orocos/rtt/Thing.hpp", "#pragma once\nnamespace RTT { struct Thing { int number; }; }\n");
    fs::create_directories(dir / "first/bin");
    fs::copy_file(TYPEGEN, dir / "first/bin/typegen");
    fs::rename(dir / "first", dir / "second");
    dir.write("types.hpp", useOf("rtt/Thing.hpp"));
    const Outcome outcome = typegen(dir / "second/bin/typegen", dir.path(), {"-o", "out", "demo", "types.hpp"});
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.status, 0);
}

TEST(OwnPrefix, FoldersOfTheUserComeFirst) {
    const TempDir dir;
    dir.write("mine/rtt/ConnPolicy.hpp", "#pragma once\nnamespace RTT { struct Thing { int number; }; }\n");
    dir.write("types.hpp", useOf("rtt/ConnPolicy.hpp"));
    const Outcome outcome = typegen(TYPEGEN, dir.path(), {"-I", "mine", "-o", "out", "demo", "types.hpp"});
    EXPECT_EQ(outcome.err, "");
}

TEST(OwnPrefix, WhereNoneIsTheHintNamesThePackage) {
    const TempDir dir;
    fs::create_directories(dir / "alone/bin");
    fs::copy_file(TYPEGEN, dir / "alone/bin/typegen");
    dir.write("types.hpp", useOf("rtt/Thing.hpp"));
    const Outcome outcome = typegen(dir / "alone/bin/typegen", dir.path(), {"-o", "out", "demo", "types.hpp"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(
        outcome.err,
        "types.hpp:2:10: error: 'rtt/Thing.hpp' file not found\n#include <rtt/Thing.hpp>\n         ^\n"
        "note: the toolchain's headers are not beside this program: pass -i orocos-rtt, or -I with the folder that "
        "holds rtt/\n");
}

TEST(MissingHeader, IsFoundInThePackageAndInThoseBesideIt) {
    const TempDir dir;
    dir.write("hand/CMakeLists.txt", "");
    dir.write("hand/include/hand/finger.hpp", "");
    dir.write("arm/include/arm/arm.hpp", "");
    const std::string types = dir.write("hand/src/types.hpp", useOf("hand/finger.hpp")).string();
    const std::string own = (dir / "hand/include").string(), other = (dir / "arm/include").string();
    EXPECT_EQ(cxx::folderHint("hand/finger.hpp", types), "it is in " + own + ": pass -I " + own);
    EXPECT_EQ(cxx::folderHint("arm/arm.hpp", types), "it is in " + other + ": pass -I " + other);
    EXPECT_EQ(cxx::folderHint("leg/leg.hpp", types), "");

    const Outcome outcome = typegen(TYPEGEN, dir / "hand", {"-o", "out", "demo", "src/types.hpp"});
    EXPECT_NE(outcome.err.find("\nnote: it is in include: pass -I include\n"), std::string::npos) << outcome.err;
    EXPECT_EQ(typegen(TYPEGEN, dir / "hand", {"-o", "out", "demo", "-I", "include", "src/types.hpp"})
                  .err.find("file not found"),
              std::string::npos);
}

}  // namespace oroforge::test
