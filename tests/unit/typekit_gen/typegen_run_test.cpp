// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <driver/typegen.hpp>

#include <filesystem>
#include <set>
#include <sstream>

#include <support/golden.hpp>
#include <support/temp_dir.hpp>

#include <gtest/gtest.h>

namespace fs = std::filesystem;
using namespace oroforge::test;

namespace {

int typegen(const std::vector<std::string>& words, std::string* output = nullptr) {
    std::ostringstream out, err;
    const int status = oroforge::typekit::run(words, out, err);
    if (output != nullptr) *output = out.str();
    EXPECT_TRUE(status != 0 || err.str().empty()) << err.str();
    return status;
}

const char* const kHeader =
    "#pragma once\n#include <vector>\nnamespace demo { struct A { std::vector<double> v; }; }\n";

}  // namespace

TEST(Typegen, ListsOutputsWithoutReadingAnything) {
    std::string listed;
    EXPECT_EQ(typegen({"--list-outputs", "-o", "/some/where", "demo", "absent.hpp"}, &listed), 0);
    EXPECT_EQ(listed,
              "/some/where/Plugin.cpp\n/some/where/types_absent.cpp\n/some/where/types/demo/typekit/Types.hpp\n");
    EXPECT_EQ(typegen({"--list-outputs", "-o", "x", "--pieces=a.hpp=2", "--include-as=/b/a.hpp=demo/a.hpp", "demo",
                       "a.hpp", "/b/a.hpp", "a.hpp"},
                      &listed),
              0);
    EXPECT_EQ(
        listed,
        "x/Plugin.cpp\nx/types_a_hpp_1.cpp\nx/types_a_hpp_2.cpp\nx/types_demo_a.cpp\nx/types/demo/typekit/Types.hpp\n");
}

TEST(Typegen, WritesExactlyTheListedFiles) {
    const TempDir dir;
    const auto header = dir.write("include/demo/types.hpp", kHeader).string();
    ASSERT_EQ(typegen({"-o", (dir / "out").string(), "demo", header}), 0);
    std::string listed;
    typegen({"--list-outputs", "-o", (dir / "out").string(), "demo", header}, &listed);
    std::istringstream lines(listed);
    std::size_t count = 0;
    for (std::string line; std::getline(lines, line); ++count) EXPECT_TRUE(fs::exists(line)) << line;
    EXPECT_EQ(readTree(dir / "out").size(), count);
}

TEST(Typegen, OutputDoesNotDependOnThePlace) {
    const TempDir one, two;
    ASSERT_EQ(typegen({"-o", (one / "out").string(), "-I" + (one / "include").string(), "demo",
                       one.write("include/demo/types.hpp", kHeader).string()}),
              0);
    const fs::path before = fs::current_path();
    two.write("include/demo/types.hpp", kHeader);
    fs::current_path(two.path());
    const int status = typegen({"-o", "elsewhere", "-Iinclude", "demo", "include/demo/types.hpp"});
    fs::current_path(before);
    ASSERT_EQ(status, 0);
    EXPECT_EQ(readTree(one / "out"), readTree(two / "elsewhere"));
}

// Matrix case 93.
TEST(Typegen, OutputDoesNotDependOnBlanksAndUmlautsInThePlace) {
    const TempDir dir;
    std::vector<std::map<std::string, std::string>> outputs;
    for (const std::string place : {"plain/", "ein Ordner für $x/"}) {
        dir.write(place + "include/demo/inner.hpp", "#pragma once\nnamespace demo { struct In { int i; }; }\n");
        const auto header =
            dir.write(place + "include/demo/types.hpp",
                      "#pragma once\n#include <demo/inner.hpp>\nnamespace demo { struct A { In in; }; }\n");
        const std::string out = (dir / place).string() + "out", depfile = (dir / place).string() + "d";
        ASSERT_EQ(typegen({"-o", out, "--depfile", depfile, "-I" + (dir / place).string() + "include", "demo",
                           header.string()}),
                  0);
        outputs.push_back(readTree(out));
    }
    EXPECT_EQ(outputs[0], outputs[1]);
    const std::string text = readFile(dir / "ein Ordner für $x/d");
    EXPECT_NE(text.find("ein\\ Ordner\\ für\\ $$x/include/demo/inner.hpp"), std::string::npos) << text;
}

// Matrix case 94.
TEST(Typegen, ReadsTreesOfSymbolicLinks) {
    const TempDir dir;
    dir.write("real/sibling.hpp", "#pragma once\nnamespace demo { struct In { int i; }; }\n");
    dir.write("real/types.hpp", "#pragma once\n#include \"sibling.hpp\"\nnamespace demo { struct A { In in; }; }\n");
    fs::create_directories(dir / "linked/include/files");
    fs::create_directory_symlink("../../real", dir / "linked/include/demo");
    for (const char* name : {"types.hpp", "sibling.hpp"})
        fs::create_symlink("../../../real/" + std::string(name), dir / "linked/include/files" / name);
    const std::string include = "-I" + (dir / "linked/include").string();
    for (const std::string folder : {"demo", "files"}) {
        const std::string out = (dir / ("out_" + folder)).string();
        ASSERT_EQ(typegen({"-o", out, include, "demo", (dir / ("linked/include/" + folder + "/types.hpp")).string()}),
                  0);
        const std::string text = readFile(dir / ("out_" + folder + "/types/demo/typekit/Types.hpp"));
        EXPECT_NE(text.find("#include <" + folder + "/types.hpp>"), std::string::npos) << text;
    }
    // Relative, and seen from within the tree of links.
    const fs::path before = fs::current_path();
    fs::current_path(dir / "linked");
    const int status = typegen({"-o", "out", "-Iinclude", "demo", "include/demo/types.hpp"});
    fs::current_path(before);
    ASSERT_EQ(status, 0);
    EXPECT_EQ(readTree(dir / "linked/out"), readTree(dir / "out_demo"));
}

// Matrix case 95.
TEST(Typegen, OutputDoesNotDependOnLineEndsAndByteOrderMark) {
    const TempDir dir;
    const std::string text =
        "#pragma once\n/// What it is\n/// for.\nstruct A {\n    /** @unit m\n     *  @range 0..1 */\n    double x;\n"
        "    int y;  ///< count\n};\nenum class E { one,  ///< first\n two };\n";
    std::string crlf = "\xEF\xBB\xBF";
    for (const char c : text) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
    std::vector<std::map<std::string, std::string>> outputs;
    for (const std::string& content : {text, crlf}) {
        const auto header = dir.write("include/demo/types.hpp", content).string();
        ASSERT_EQ(typegen({"-o", (dir / "out").string(), "demo", header}), 0);
        outputs.push_back(readTree(dir / "out"));
    }
    EXPECT_EQ(outputs[0], outputs[1]);
}

TEST(Typegen, GeneratesTheStructsBesideClassesThatAreNoValues) {
    const TempDir dir;
    const std::string text =
        "#pragma once\nnamespace demo {\nclass Filter {\n    double state_;\n};\nclass Base {\npublic:\n"
        "    virtual ~Base();\n    struct Inner { int i; };\n};\nstruct Gains { double p; };\n}\n";
    const auto header = dir.write("types.hpp", text).string();
    const std::vector<std::string> words = {"-o", (dir / "out").string(), "demo", header};
    std::ostringstream out, err;
    EXPECT_EQ(oroforge::typekit::run(words, out, err), 0) << err.str();
    EXPECT_NE(err.str().find("types.hpp:3:7: warning: [TK013] type 'demo::Filter' is left out: "), std::string::npos)
        << err.str();
    const std::string types = readFile(dir / "out/types/demo/typekit/Types.hpp");
    EXPECT_NE(types.find("demo::Gains"), std::string::npos);
    EXPECT_NE(types.find("demo::Base::Inner"), std::string::npos);
    EXPECT_EQ(types.find("Filter"), std::string::npos);
    // Warnings are seen again, though nothing has changed.
    std::ostringstream again;
    EXPECT_EQ(oroforge::typekit::run(words, out, again), 0);
    EXPECT_EQ(again.str(), err.str());
    std::vector<std::string> strict = words;
    strict.push_back("--strict");
    EXPECT_EQ(typegen(strict), 1);
}

TEST(Typegen, UnchangedFilesKeepTheirTimes) {
    const TempDir dir;
    const auto header = dir.write("types.hpp", kHeader).string();
    const std::vector<std::string> words = {"-o", (dir / "out").string(), "demo", header};
    ASSERT_EQ(typegen(words), 0);
    const fs::path file = dir / "out/types_types.cpp";
    const auto old = fs::last_write_time(file) - std::chrono::hours(1);
    fs::last_write_time(file, old);
    ASSERT_EQ(typegen(words), 0);
    EXPECT_EQ(fs::last_write_time(file), old);
}

TEST(Typegen, RemovesItsSourcesForHeadersThatAreNoLongerListed) {
    const TempDir dir;
    const auto header = dir.write("tank.hpp", kHeader).string();
    const auto gone = dir.write("gone.hpp", "#pragma once\nstruct Gone { int i; };\n").string();
    const std::string out = (dir / "out").string();
    ASSERT_EQ(typegen({"-o", out, "demo", header, gone}), 0);
    dir.write("out/types_mine.cpp", "// by hand\n");
    ASSERT_EQ(
        typegen({"-o", out, "--pieces=" + header + "=2", "demo", header, header, (dir / ".").string() + "/tank.hpp"}),
        0);
    std::set<std::string> names;
    for (const auto& [name, text] : readTree(dir / "out")) names.insert(name);
    EXPECT_EQ(names, (std::set<std::string>{"Plugin.cpp", "types/demo/typekit/Types.hpp", "types_mine.cpp",
                                            "types_tank_1.cpp", "types_tank_2.cpp"}));
}

TEST(Typegen, SaysThatAHeaderHasNoTypes) {
    const TempDir dir;
    const auto header = dir.write("tank.hpp", kHeader).string();
    const auto config = dir.write("config.hpp", "#pragma once\n#define N 3\n").string();
    ASSERT_EQ(typegen({"-o", (dir / "out").string(), "demo", config, header}), 0);
    EXPECT_EQ(readFile(dir / "out/types_config.cpp"),
              "// Generated by typegen from config.hpp. Do not edit: changes are lost at the next build.\n\n"
              "// No type belongs to this file.\n");
    EXPECT_EQ(readFile(dir / "out/Plugin.cpp").find("addTypes_config"), std::string::npos);
}

TEST(Typegen, DepfileNamesEveryHeaderAbsolutely) {
    const TempDir dir;
    dir.write("inner.hpp", kHeader);
    const auto header = dir.write("types.hpp", "#include \"inner.hpp\"\n").string();
    // Nothing is defined in types.hpp itself: a warning, no error.
    std::ostringstream out, err;
    EXPECT_EQ(oroforge::typekit::run({"-o", (dir / "out").string(), "--depfile", (dir / "d").string(), "demo", header},
                                     out, err),
              0);
    EXPECT_NE(err.str().find("warning: [TK061]"), std::string::npos) << err.str();
    const std::string text = readFile(dir / "d");
    EXPECT_NE(text.find((dir / "out/Plugin.cpp").string()), std::string::npos);
    EXPECT_NE(text.find((dir / "inner.hpp").string()), std::string::npos);
    EXPECT_NE(text.find("/vector"), std::string::npos);
    EXPECT_EQ(text.find("/../"), std::string::npos);
}

TEST(Typegen, DepfileIsAboutAnotherFileOnRequest) {
    const TempDir dir;
    const auto header = dir.write("types.hpp", kHeader).string();
    ASSERT_EQ(typegen({"-o", (dir / "out").string(), "--depfile", (dir / "d").string(), "--depfile-target=/a/stamp",
                       "demo", header}),
              0);
    EXPECT_EQ(readFile(dir / "d").compare(0, 10, "/a/stamp: "), 0) << readFile(dir / "d");
}

TEST(Typegen, IncludesAHeaderUnderTheGivenName) {
    const TempDir dir;
    const auto header = dir.write("types.hpp", kHeader).string();
    ASSERT_EQ(typegen({"-o", (dir / "out").string(), "--include-as=" + header + "=demo/types.hpp", "demo", header}), 0);
    const std::string text = readFile(dir / "out/types/demo/typekit/Types.hpp");
    EXPECT_NE(text.find("#include <demo/types.hpp>"), std::string::npos) << text;
}

TEST(Typegen, ReadsHeadersWithTheOptionsOfAFile) {
    const TempDir dir;
    const auto flags = dir.write("flags", "-O2\n-std=c++11\n-DUSE_FLOAT\n").string();
    const auto header = dir.write("types.hpp",
                                  "#pragma once\n#include <string_view>\n#ifdef USE_FLOAT\nstruct A { float x; };\n"
                                  "#else\nstruct A { int x; };\n#endif\n")
                            .string();
    std::string model;
    ASSERT_EQ(typegen({"--dump=model", "--flags-from", flags, "demo", header}, &model), 0);
    EXPECT_NE(model.find("\"float\""), std::string::npos) << model;
}

TEST(Typegen, DoesNotReplaceAFileOfTheUser) {
    const TempDir dir;
    const auto header = dir.write("types.hpp", kHeader).string();
    dir.write("out/Plugin.cpp", "// by hand\n");
    EXPECT_EQ(typegen({"-o", (dir / "out").string(), "demo", header}), 1);
    EXPECT_EQ(readFile(dir / "out/Plugin.cpp"), "// by hand\n");
    EXPECT_FALSE(fs::exists(dir / "out/types_types.cpp"));
}

TEST(Typegen, FailureLeavesEarlierOutputAlone) {
    const TempDir dir;
    const auto header = dir.write("types.hpp", kHeader).string();
    const std::vector<std::string> words = {"-o", (dir / "out").string(), "demo", header};
    ASSERT_EQ(typegen(words), 0);
    const auto before = readTree(dir / "out");
    dir.write("types.hpp", "struct Bad { int* p; };");
    EXPECT_EQ(typegen(words), 1);
    EXPECT_EQ(readTree(dir / "out"), before);
}

TEST(Typegen, TemplatesCanBeReplaced) {
    const TempDir dir;
    const auto header = dir.write("types.hpp", kHeader).string();
    dir.write("templates/typekit/Plugin.cpp.mustache", "// {{name}} of mine\n");
    ASSERT_EQ(typegen({"-o", (dir / "out").string(), "--template-dir", (dir / "templates").string(), "demo", header}),
              0);
    EXPECT_EQ(readFile(dir / "out/Plugin.cpp"), "// demo of mine\n");
    dir.write("templates/typekit/Plugin.cpp.mustache", "{{misspelt}}");
    EXPECT_EQ(typegen({"-o", (dir / "out").string(), "--template-dir", (dir / "templates").string(), "demo", header}),
              1);
}

TEST(Typegen, DumpsTheView) {
    const TempDir dir;
    std::string view;
    ASSERT_EQ(typegen({"--dump=view", "demo", dir.write("types.hpp", kHeader).string()}, &view), 0);
    EXPECT_NE(view.find("\"userHeader\": \"types/demo/typekit/Types.hpp\""), std::string::npos);
}

TEST(Typegen, HelpAndVersionSucceed) {
    std::string text;
    EXPECT_EQ(typegen({"--help"}, &text), 0);
    EXPECT_EQ(text.compare(0, 15, "usage: typegen "), 0);
    EXPECT_EQ(typegen({"--version"}, &text), 0);
    EXPECT_EQ(text.compare(0, 8, "typegen "), 0);
}
