// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <flags/compile_database.hpp>

#include <sstream>

#include <flags/command_words.hpp>
#include <driver/typegen.hpp>
#include <support/temp_dir.hpp>

#include <gtest/gtest.h>

using namespace oroforge;
using oroforge::test::TempDir;
using Words = std::vector<std::string>;

namespace {

std::string entry(const std::string& file, const std::string& command, const std::string& directory = ".") {
    return "{\"directory\": \"" + directory + "\", \"file\": \"" + file + "\", \"command\": \"" + command + "\"}";
}

struct Taken {
    Words flags;
    std::string source;
    std::string error;
};

Taken take(const std::string& database, const std::string& wanted = "", const Words& headers = {}) {
    diag::Sink sink;
    const auto found = flags::readCompileDatabase(database, wanted, headers, sink);
    EXPECT_EQ(found.has_value(), sink.empty());
    Taken taken;
    if (found) taken = {found->flags, found->source, ""};
    for (const auto& diagnostic : sink.all()) {
        EXPECT_EQ(diagnostic.code, "TK066");
        taken.error += std::to_string(diagnostic.where.line) + ":" + std::to_string(diagnostic.where.column) + ": " +
                       diagnostic.message + "\n";
    }
    return taken;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST(CompileDatabase, SplitsCommandsAsAShellDoes) {
    EXPECT_EQ(flags::splitCommand(R"(g++ -DA=\"x\ y\" '-DB=a "b"' "-DC=\"q\" \n" -I"a b"/c '' -DD=\\)"),
              (Words{"g++", "-DA=\"x y\"", "-DB=a \"b\"", "-DC=\"q\" \\n", "-Ia b/c", "", "-DD=\\"}));
}

TEST(CompileDatabase, PassesOnWhatChangesTheMeaningOfHeaders) {
    const Words command = {"ccache", "g++", "-Ia",          "-I",  "b",        "-isystem", "/c",       "-DX=1",
                           "-D",     "Y",   "-UZ",          "-O2", "-Wall",    "-fPIC",    "-std=c11", "-std=gnu++20",
                           "-o",     "-Io", "-MF",          "x.d", "-include", "none.hpp", "-Xclang",  "-include",
                           "-c",     "x.c", "-include-pch", "p",   "--",       "-Ilast"};
    EXPECT_EQ(flags::flagsOfCommand(command, "/dir"),
              (Words{"-I", "/dir/a", "-I", "/dir/b", "-isystem", "/c", "-D", "X=1", "-D", "Y", "-U", "Z",
                     "-std=gnu++20", "-include", "none.hpp"}));
    EXPECT_EQ(flags::flagsOfCommand({"g++", "-std=c++14"}, "/dir"), Words{});
}

TEST(CompileDatabase, ReadsResponseFiles) {
    const TempDir dir;
    dir.write("words.rsp", "-DX \"-Ia b\"\n@words.rsp");
    EXPECT_EQ(flags::flagsOfCommand({"g++", "@words.rsp", "@absent"}, dir.path().string()).size() % 4, 0U);
    dir.write("words.rsp", "-DX \"-Ia b\"\n");
    EXPECT_EQ(flags::flagsOfCommand({"g++", "@words.rsp"}, dir.path().string()),
              (Words{"-D", "X", "-I", (dir / "a b").string()}));
}

TEST(CompileDatabase, TakesFoldersForNoResponseFiles) {
    const TempDir dir;
    dir.write("folder/words.rsp", "-DX");
    EXPECT_EQ(flags::flagsOfCommand({"g++", "@folder", "@", "@.", "-DY"}, dir.path().string()), (Words{"-D", "Y"}));
}

TEST(CompileDatabase, ReadsResponseFilesThatNameEachOtherOnce) {
    const TempDir dir;
    std::string text = "-DX\n";
    for (int i = 0; i != 100; ++i) text += "@words.rsp @other.rsp\n";
    dir.write("words.rsp", text);
    dir.write("other.rsp", "-DY @words.rsp");
    EXPECT_EQ(flags::flagsOfCommand({"g++", "@words.rsp"}, dir.path().string()).size(), 2U + 100U * 2U);
}

TEST(CompileDatabase, TakesTheSourceThatIncludesMostHeaders) {
    const TempDir dir;
    const auto a = dir.write("include/demo/a.hpp", "").string(), b = dir.write("include/demo/b.hpp", "").string();
    dir.write("src/one.cpp", "#include <demo/a.hpp>\n");
    dir.write("src/both.cpp", "  # include \"../include/demo/b.hpp\"\n#include <demo/a.hpp>\n");
    dir.write("include/demo/a.cpp", "#include <other/a.hpp>\n");
    const auto database =
        dir.write("compile_commands.json", "[" + entry("plain.c", "cc -DC") + "," + entry("src/one.cpp", "c++ -DONE") +
                                               "," + entry("src/both.cpp", "c++ -DBOTH") + "," +
                                               entry("include/demo/a.cpp", "c++ -DNAME") + "]");
    EXPECT_EQ(take(database.string(), "", {a, b}).flags, (Words{"-D", "BOTH"}));
    EXPECT_EQ(take(dir.path().string(), "", {a, b}).source, (dir / "src/both.cpp").string());
}

TEST(CompileDatabase, ElseTakesTheSourceOfTheSameNameOrNextToTheHeader) {
    const TempDir dir;
    const auto header = dir.write("lib/x/a.hpp", "").string();
    const std::string far = entry("app/main.cpp", "c++ -DFAR"), near = entry("lib/x/main.cpp", "c++ -DNEAR");
    const auto database = dir.write("db.json", "[" + far + "," + near + "," + entry("app/a.cpp", "c++ -DNAME") + "]");
    EXPECT_EQ(take(database.string(), "", {header}).flags, (Words{"-D", "NAME"}));
    dir.write("db.json", "[" + far + "," + near + "]");
    EXPECT_EQ(take(database.string(), "", {header}).flags, (Words{"-D", "NEAR"}));
    EXPECT_TRUE(
        has(take(database.string(), "", {"/elsewhere/b.hpp"}).error, "no source in this compile database includes"));
}

TEST(CompileDatabase, TakesTheEntryOfASourceOrATarget) {
    const TempDir dir;
    const auto database =
        dir.write("db.json", "[" + entry("a/main.cpp", "c++ -DA -o CMakeFiles/one.dir/a/main.cpp.o") + "," +
                                 entry("b/main.cpp", "c++ -DB -o CMakeFiles/two.dir/b/main.cpp.o") + "]")
            .string();
    EXPECT_EQ(take(database, "b/main.cpp").flags, (Words{"-D", "B"}));
    EXPECT_EQ(take(database, (dir / "b/main.cpp").string()).flags, (Words{"-D", "B"}));
    EXPECT_EQ(take(database, "two").flags, (Words{"-D", "B"}));
    EXPECT_TRUE(has(take(database, "main.cpp").error, "compiled twice")) << take(database, "main.cpp").error;
    EXPECT_TRUE(has(take(database, "mian.cpp").error, "did you mean 'main.cpp'?")) << take(database, "mian.cpp").error;
    EXPECT_TRUE(has(take(database, "in.cpp").error, "no entry")) << "a part of a name is not its end";
}

TEST(CompileDatabase, SaysWhatIsWrongAndWhere) {
    const TempDir dir;
    const auto error = [&](const std::string& text) { return take(dir.write("db.json", text).string()).error; };
    EXPECT_TRUE(has(take((dir / "absent").string()).error, "no such compile database"));
    EXPECT_TRUE(has(take(dir.path().string()).error, "no such compile database")) << "a folder without one";
    EXPECT_EQ(error("[\n  {\"directory\": x}\n]"), "2:17: this is not JSON: unexpected 'x'\n");
    EXPECT_EQ(error("[1,"), "1:4: this is not JSON: unexpected the end of the file\n");
    EXPECT_EQ(error(""), "1:1: this is not JSON: unexpected the end of the file\n");
    EXPECT_TRUE(has(error("{}"), "found a JSON object, expected a list"));
    EXPECT_TRUE(has(error("[]"), "no entry"));
    EXPECT_EQ(error("[1, {}, " + entry("x", "") + ", {\"directory\": \"d\", \"file\": \"f\", \"arguments\": [1]}]"),
              "0:0: entry 1 is a JSON number, expected an object\n0:0: entry 2 has no text 'file'\n"
              "0:0: entry 3 (x) has neither 'command' nor 'arguments'\n"
              "0:0: entry 4 (f) has 'arguments' that are not all texts\n");
}

TEST(CompileDatabase, IsWeakerThanTheCommandLine) {
    EXPECT_EQ(flags::withoutOverridden({"-std=c++17", "-D", "A=1", "-D", "F(x)=x", "-U", "B", "-I", "/x", "-D", "C"},
                                       {"-std=c++20", "-D", "A", "-D", "B=2", "-D", "F", "-I", "/y"}),
              (Words{"-I", "/x", "-D", "C"}));
}

// Matrix case 85: a header that means nothing without the options of the target.
TEST(CompileDatabase, MakesAHeaderReadableThatNeedsItsTargetsOptions) {
    const TempDir dir;
    dir.write("third party/config.h", "#define JOINTS 6\n");
    const auto header = dir.write("include/arm.hpp",
                                  "#pragma once\n#include <config.h>\n#ifndef ARM\n#error needs ARM\n#endif\n"
                                  "struct Arm { double q[JOINTS]; };\n")
                            .string();
    dir.write("src/arm.cpp", "#include \"arm.hpp\"\n");
    dir.write(
        "build/compile_commands.json",
        "[" + entry("../src/arm.cpp", "c++ -DARM=1 '-I../third party' -c ../src/arm.cpp", (dir / "build").string()) +
            "]");
    const auto run = [&](Words words, std::string& out, std::string& err) {
        words.insert(words.end(), {"demo", header});
        std::ostringstream outStream, errStream;
        const int status = typekit::run(words, outStream, errStream);
        out = outStream.str();
        err = errStream.str();
        return status;
    };
    std::string out, err;
    EXPECT_EQ(run({"--dump=model"}, out, err), 1);
    EXPECT_EQ(run({"--dump=model", "-p", (dir / "build").string()}, out, err), 0) << err;
    EXPECT_TRUE(has(out, "\"Arm\"") || has(out, "/Arm")) << out;

    const std::string depfile = (dir / "d").string(), output = (dir / "out").string();
    EXPECT_EQ(run({"-v", "--compile-database=" + (dir / "build").string(), "--compile-database-for=arm.cpp", "-o",
                   output, "--depfile=" + depfile},
                  out, err),
              0)
        << err;
    EXPECT_TRUE(has(out, "options of " + (dir / "src/arm.cpp").string())) << out;
    EXPECT_TRUE(has(test::readFile(depfile), "compile_commands.json"));
    EXPECT_EQ(run({"--compile-database-for=arm.cpp"}, out, err), 1);
}
