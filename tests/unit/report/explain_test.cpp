// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Every code has an explanation, and what explanations show is true: the example gives the error, the advice does not.
#include <report/explain.hpp>

#include <regex>
#include <set>
#include <sstream>

#include <driver/typegen.hpp>
#include <support/child_process.hpp>
#include <support/golden.hpp>
#include <support/temp_dir.hpp>

namespace fs = std::filesystem;
using namespace oroforge;
using namespace oroforge::test;

namespace {

std::set<std::string> codesInSources() {
    const std::regex quotedCode("\"((TK|EMIT|OM|OC)[0-9]{3})\"");
    std::set<std::string> codes;
    for (const char* part :
         {"generator/adapters", "generator/check", "generator/clang", "generator/driver", "generator/emit",
          "generator/flags", "generator/manifest", "generator/merge", "generator/model", "generator/render",
          "generator/report", "generator/view", "typekit_gen"}) {
        for (const auto& [name, text] : readTree(sourceRoot() / part)) {
            for (std::sregex_iterator at(text.begin(), text.end(), quotedCode), end; at != end; ++at) {
                codes.insert((*at)[1]);
            }
        }
    }
    return codes;
}

/// The indented lines below "Example:" or "Instead:", without the indentation.
std::string block(const report::Explanation& explanation, const std::string& title) {
    std::istringstream lines(explanation.text);
    std::string result;
    bool inside = false;
    for (std::string line; std::getline(lines, line);) {
        if (!line.empty() && line[0] != ' ') inside = line == title;
        if (inside && line.compare(0, 4, "    ") == 0) result += line.substr(4) + "\n";
    }
    return result;
}

struct Ran {
    int status;
    std::string err;
};

Ran typegen(const std::string& text) {
    const TempDir dir;
    const std::string header = dir.write("example.hpp", "#pragma once\n" + text).string();
    std::ostringstream out, err;
    const int status = typekit::run({"-o", (dir / "out").string(), "demo", header}, out, err);
    return {status, err.str()};
}

Ran orocreatePkg(const std::string& manifest) {
    const TempDir dir;
    Command command;
    command.program = OROCREATE_PKG;
    command.directory = dir.path();
    command.arguments = {"--generate", dir.write("tank.xml", manifest).string(), "--output", (dir / "out").string()};
    const Outcome outcome = run(command);
    return {outcome.status, outcome.err};
}

/// Examples are headers, or of the codes OM manifests.
Ran readBy(const std::string& code, const std::string& example) {
    return code.compare(0, 2, "OM") == 0 ? orocreatePkg(example) : typegen(example);
}

std::vector<std::string> allCodes() {
    std::vector<std::string> codes;
    for (const report::Explanation& explanation : report::explanations()) codes.push_back(explanation.code);
    return codes;
}

/// Those whose explanation has such a block of C++ or XML; lines with '$' are commands.
std::vector<std::string> codesWith(const std::string& title) {
    std::vector<std::string> codes;
    for (const report::Explanation& explanation : report::explanations()) {
        const std::string text = block(explanation, title);
        if (!text.empty() && text[0] != '$') codes.push_back(explanation.code);
    }
    return codes;
}

class Explained : public testing::TestWithParam<std::string> {};
class Example : public testing::TestWithParam<std::string> {};
class WayOut : public testing::TestWithParam<std::string> {};

}  // namespace

TEST(Explanations, AreThereForEveryCodeAndForNoOther) {
    const std::set<std::string> inSources = codesInSources();
    std::set<std::string> explained;
    for (const std::string& code : allCodes()) {
        explained.insert(code);
        EXPECT_EQ(inSources.count(code), 1U) << code << " is explained but nothing reports it";
    }
    for (const std::string& code : inSources) {
        EXPECT_EQ(explained.count(code), 1U) << code << ": expected a file generator/explain/" << code << ".txt";
    }
}

TEST_P(Explained, ByATitleAndAParagraph) {
    const report::Explanation& explanation = *report::explanationOf(GetParam());
    EXPECT_FALSE(explanation.title.empty());
    EXPECT_LT(explanation.title.size(), 60U);
    EXPECT_GT(explanation.firstParagraph().size(), 80U);
    std::istringstream lines(explanation.text);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100U) << line;
}

TEST_P(Example, GivesTheCode) {
    const Ran ran = readBy(GetParam(), block(*report::explanationOf(GetParam()), "Example:"));
    EXPECT_NE(ran.err.find("[" + GetParam() + "]"), std::string::npos) << ran.err;
}

TEST_P(WayOut, IsAccepted) {
    const Ran ran = readBy(GetParam(), block(*report::explanationOf(GetParam()), "Instead:"));
    EXPECT_EQ(ran.status, 0);
    EXPECT_EQ(ran.err, "");
}

INSTANTIATE_TEST_SUITE_P(Codes, Explained, testing::ValuesIn(allCodes()), caseName);
INSTANTIATE_TEST_SUITE_P(Codes, Example, testing::ValuesIn(codesWith("Example:")), caseName);
INSTANTIATE_TEST_SUITE_P(Codes, WayOut, testing::ValuesIn(codesWith("Instead:")), caseName);
