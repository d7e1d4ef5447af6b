// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Texts and names of files that come through typegen and orocreate-pkg: UTF-8, and no way back in a path.
#include <nlohmann/json.hpp>
#include <support/child_process.hpp>
#include <support/golden.hpp>
#include <support/temp_dir.hpp>

#include <gtest/gtest.h>

namespace fs = std::filesystem;

namespace oroforge::test {
namespace {

Outcome runIn(const fs::path& folder, const char* program, std::vector<std::string> arguments) {
    Command command;
    command.program = program;
    command.directory = folder;
    command.arguments = std::move(arguments);
    return run(command);
}

bool isUtf8(const std::string& text) {
    try {
        (void)nlohmann::json(text).dump();  // throws where it is not
        return true;
    } catch (const nlohmann::json::exception&) {
        return false;
    }
}

std::string allIn(const fs::path& folder) {
    std::string all;
    for (const auto& [name, text] : readTree(folder)) {
        EXPECT_TRUE(isUtf8(text)) << name;
        all += text;
    }
    return all;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// "Höhe über Grund" and "°C" in Latin-1.
const char* const kHeader =
    "#pragma once\n#include <string>\n/// H\xf6he\nstruct A {\n    double h;  ///< \xfc"
    "ber Grund @unit \xb0"
    "C\n"
    "    [[oro::doc(\"gr\xf6\xdf"
    "er\"), oro::unit(\"\xb0"
    "F\")]] double g;\n};\n";

}  // namespace

TEST(Latin1, CommentsOfHeadersAreConverted) {
    const TempDir dir;
    dir.write("types.hpp", kHeader);
    const Outcome outcome = runIn(dir.path(), TYPEGEN, {"-o", "out", "demo", "types.hpp"});
    EXPECT_EQ(outcome.err, "");
    const std::string all = allIn(dir / "out");
    for (const char* text : {"H\xc3\xb6he",
                             "\xc3\xbc"
                             "ber Grund",
                             "\xc2\xb0"
                             "C",
                             "gr\xc3\xb6\xc3\x9f"
                             "er",
                             "\xc2\xb0"
                             "F"})
        EXPECT_TRUE(has(all, text)) << text;
    const Outcome model = runIn(dir.path(), TYPEGEN, {"--dump=model", "demo", "types.hpp"});
    EXPECT_TRUE(has(model.out,
                    "\xc3\xbc"
                    "ber Grund"))
        << model.out;
}

TEST(Latin1, CommentsOfComponentsAreConverted) {
    const TempDir dir;
    dir.write(
        "arm.hpp",
        "#pragma once\n#include <rtt/Component.hpp>\n#include <rtt/RTT.hpp>\n/// F\xfchrt den Arm.\n"
        "class Arm : public RTT::TaskContext {\npublic:\n    explicit Arm(const std::string& name) : "
        "RTT::TaskContext(name) {\n        addProperty(\"l\", l_).doc(\"L\xe4nge\");\n    }\n    std::string l_ = "
        "\"gr\xfc"
        "n\";\n};\nORO_CREATE_COMPONENT(Arm)\n");
    const Outcome outcome = runIn(dir.path(), OROCREATE_PKG, {"--describe", "arm.hpp"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(isUtf8(outcome.out));
    EXPECT_TRUE(has(outcome.out, "F\xc3\xbchrt den Arm.")) << outcome.out;
    EXPECT_TRUE(has(outcome.out, "L&#228;nge")) << outcome.out;
}

TEST(Latin1, AuthorsOnTheCommandLineAreConverted) {
    const TempDir dir;
    const Outcome outcome = runIn(dir.path(), OROCREATE_PKG,
                                  {"arm", "--author", "J\xf6rg M\xfcller <j@example.org>", "--license", "L\xfc"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(has(allIn(dir / "arm"), "J\xc3\xb6rg M\xc3\xbcller"));
}

TEST(Latin1, ManifestsAreRefusedAtTheByte) {
    const TempDir dir;
    dir.write(
        "m.xml",
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<package name=\"arm\">\n  <description>F\xfcr</description>\n"
        "</package>\n");
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"--generate", "m.xml", "-o", "out"}, {"--from", "m.xml"}}) {
        const Outcome outcome = runIn(dir.path(), OROCREATE_PKG, words);
        EXPECT_EQ(outcome.status, 1);
        EXPECT_TRUE(has(outcome.err, "m.xml:3:17: error: [XML009] found the byte 0xfc, expected text in UTF-8"))
            << outcome.err;
        EXPECT_FALSE(fs::exists(dir / "out"));
        EXPECT_FALSE(fs::exists(dir / "arm"));
    }
}

TEST(Latin1, ReportsForProgramsAreUtf8) {
    const TempDir dir;
    dir.write("types.hpp", "#pragma once\nstruct A { int* h; /* H\xf6he */ };\n#error \"\xfc\"\n");
    for (const std::string format : {"json", "sarif"}) {
        const Outcome outcome = runIn(dir.path(), TYPEGEN, {"--format=" + format, "-o", "out", "demo", "types.hpp"});
        EXPECT_EQ(outcome.status, 1);
        EXPECT_TRUE(isUtf8(outcome.out));
    }
}

TEST(PlainPaths, NotesHaveNoDotsAndNoDoubleSlashes) {
    const TempDir dir;
    dir.write("include/types.hpp", "#pragma once\n#include \"../lib//m.hpp\"\nstruct Z { M m; };\n");
    dir.write("lib/m.hpp", "#pragma once\nclass M { int x; };\n");
    const Outcome outcome = runIn(dir.path(), TYPEGEN, {"-o", "out", "demo", "include/../include//types.hpp"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(has(outcome.err, "\nlib/m.hpp:2:15: note: ")) << outcome.err;
    EXPECT_EQ(outcome.err.compare(0, 24, "include/types.hpp:3:14: "), 0) << outcome.err;
}

TEST(PlainPaths, WhereALinkLeadsElsewhereItStaysAsItIs) {
    const TempDir dir;
    dir.write("far/away/types.hpp", "#pragma once\n#include \"../m.hpp\"\nstruct Z { M m; };\n");
    dir.write("far/m.hpp", "#pragma once\nclass M { int x; };\n");
    dir.write("m.hpp", "#pragma once\nclass M { int x; };\n");
    fs::create_directory_symlink("far/away", dir / "near");
    const Outcome outcome = runIn(dir.path(), TYPEGEN, {"-o", "out", "demo", "near/types.hpp"});
    EXPECT_TRUE(has(outcome.err, "\nnear/../m.hpp:2:15: note: ")) << outcome.err;
}

}  // namespace oroforge::test
