// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Applies what --format=json proposes to the header; then typegen and the compiler have no complaint left.
#include <sstream>

#include <support/child_process.hpp>
#include <support/golden.hpp>
#include <support/run_typegen.hpp>
#include <support/temp_dir.hpp>

namespace fs = std::filesystem;
using namespace oroforge::test;

namespace {

struct Case {
    std::string name, before, after;
};

void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

/// typegen's JSON report about the header.
std::string report(const fs::path& header, int expected) {
    const Ran ran = runTypegen({"--format=json", "-o" + header.string() + ".out", "demo", header.string()});
    EXPECT_EQ(ran.status, expected) << ran.out;
    EXPECT_EQ(ran.err, "");
    return ran.out;
}

Outcome applyFixes(const fs::path& report) {
    Command apply;
    apply.program = "/usr/bin/python3";
    apply.arguments = {(sourceRoot() / "tests/support/apply_fixes.py").string(), report.string()};
    return run(apply);
}

Outcome checkSyntax(const fs::path& source, const fs::path& folder) {
    Command compile;
    std::istringstream words(SYNTAX_CHECK);
    std::getline(words, compile.program, '|');
    for (std::string word; std::getline(words, word, '|');) compile.arguments.push_back(word);
    compile.arguments.insert(compile.arguments.end(), {"-I", folder.string(), source.string()});
    return run(compile);
}

class FixIt : public testing::TestWithParam<Case> {};

const std::vector<Case> kCases = {
    {"const_and_volatile",
     "#pragma once\n#include <string>\nstruct A {\n    volatile int a = 1;\n    int volatile b = 2;\n"
     "    const std::string c[2];\n    volatile char d[4] = \"abc\";\n};\n",
     "#pragma once\n#include <string>\nstruct A {\n    int a = 1;\n    int b = 2;\n"
     "    std::string c[2];\n    char d[4] = \"abc\";\n};\n"},
    {"c_strings",
     "#pragma once\nstruct A {\n    const char* a;\n    char const *b = nullptr;\n    const char* const c = \"c\";\n"
     "    const char* d{};\n    const char* e = 0;\n};\n",
     "#pragma once\n#include <string>\nstruct A {\n    std::string a;\n    std::string b;\n    std::string c = \"c\";\n"
     "    std::string d{};\n    std::string e;\n};\n"},
    {"string_view",
     "#ifndef A_HPP\n#define A_HPP\n#include <string_view>\nnamespace demo {\nstruct A { std::string_view name = "
     "\"n\"; };\n}\n#endif\n",
     "#ifndef A_HPP\n#define A_HPP\n#include <string>\n#include <string_view>\nnamespace demo {\n"
     "struct A { std::string name = \"n\"; };\n}\n#endif\n"},
    {"no_guard", "struct A { volatile int x = 0; };\n", "#pragma once\nstruct A { int x = 0; };\n"},
    {"no_guard_byte_order_mark", "\xEF\xBB\xBFstruct A { volatile int x = 0; };\n",
     "\xEF\xBB\xBF#pragma once\nstruct A { int x = 0; };\n"},
    {"forgotten_semicolon", "#pragma once\nstruct A { int x }\n;\n", "#pragma once\nstruct A { int x; }\n;\n"},
    {"in_a_class_of_a_class", "#pragma once\nstruct A { struct B { volatile float f = 0; } b; };\n",
     "#pragma once\nstruct A { struct B { float f = 0; } b; };\n"},
    {"windows_line_ends", "#pragma once\r\nstruct A {\r\n    volatile int x = 0;\r\n};\r\n",
     "#pragma once\r\nstruct A {\r\n    int x = 0;\r\n};\r\n"},
};

std::string nameOf(const testing::TestParamInfo<Case>& info) { return info.param.name; }

}  // namespace

TEST_P(FixIt, RepairsTheHeader) {
    const TempDir dir;
    const fs::path header = dir.write("types.hpp", GetParam().before);
    const std::string& before = GetParam().before;
    const bool isError = before.find("const ") != std::string::npos || before.find("volatile ") != std::string::npos ||
                         GetParam().name == "string_view" || GetParam().name == "forgotten_semicolon";
    dir.write("report.json", report(header, isError ? 1 : 0));
    const Outcome applied = applyFixes(dir / "report.json");
    ASSERT_EQ(applied.status, 0) << applied.err;
    EXPECT_EQ(readFile(header), GetParam().after);
    EXPECT_NE(report(header, 0).find("\"diagnostics\": []"), std::string::npos);
    for (const auto& entry : fs::directory_iterator(dir / "types.hpp.out")) {
        if (entry.path().extension() != ".cpp") continue;
        if (GetParam().name != "c_strings" && entry.path().filename() != "Plugin.cpp") continue;
        const Outcome compiled = checkSyntax(entry.path(), dir.path());
        EXPECT_EQ(compiled.status, 0) << compiled.err;
    }
}

INSTANTIATE_TEST_SUITE_P(Headers, FixIt, testing::ValuesIn(kCases), nameOf);

TEST(FixIt, ProposesNothingWhereItIsNotByTheLetter) {
    const TempDir dir;
    const fs::path header = dir.write("types.hpp",
                                      "#pragma once\n#define VOLATILE volatile\nusing Fixed = volatile int;\n"
                                      "inline const char* text() { return \"\"; }\n"
                                      "struct A {\n    const char *a, *b;\n    VOLATILE int c = 0;\n    Fixed d = 0;\n"
                                      "    const char* e = text();\n    char* f;\n};\n");
    const std::string text = report(header, 1);
    EXPECT_EQ(text.find("replacement"), std::string::npos) << text;
    EXPECT_NE(text.find("\"fixes\": []"), std::string::npos);
}
