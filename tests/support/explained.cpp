// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "explained.hpp"

#include "golden.hpp"

#include <gtest/gtest.h>

#include <regex>
#include <sstream>

namespace oroforge::test {
namespace {

std::set<std::string> quotedCodes(const std::vector<std::string>& folders, const std::string& prefixes) {
    const std::regex quotedCode("\"((" + prefixes + ")[0-9]{3})\"");
    std::set<std::string> codes;
    for (const std::string& folder : folders)
        for (const auto& [name, text] : readTree(sourceRoot() / folder))
            for (std::sregex_iterator at(text.begin(), text.end(), quotedCode), end; at != end; ++at)
                codes.insert((*at)[1]);
    return codes;
}

}  // namespace

diag::Explanations explanationsIn(const std::string& folder) {
    const auto files = readTree(sourceRoot() / folder);
    diag::EmbeddedFiles texts;
    for (const auto& [name, text] : files)
        texts.push_back({std::string_view(name).substr(0, name.size() - std::string_view(".txt").size()), text});
    return diag::Explanations(texts);
}

std::vector<std::string> codesOf(const diag::Explanations& explanations) {
    std::vector<std::string> codes;
    for (const diag::Explanation& explanation : explanations.all()) codes.push_back(explanation.code);
    return codes;
}

std::vector<std::string> codesWith(const std::string& title, const diag::Explanations& explanations) {
    std::vector<std::string> codes;
    for (const diag::Explanation& explanation : explanations.all()) {
        const std::string text = block(explanation, title);
        if (!text.empty() && text[0] != '$') codes.push_back(explanation.code);
    }
    return codes;
}

std::string block(const diag::Explanation& explanation, const std::string& title) {
    std::istringstream lines(explanation.text);
    std::string result;
    bool inside = false;
    for (std::string line; std::getline(lines, line);) {
        if (!line.empty() && line[0] != ' ') inside = line == title;
        if (inside && line.compare(0, 4, "    ") == 0) result += line.substr(4) + "\n";
    }
    return result;
}

void expectExplained(const diag::Explanations& explanations, const std::vector<std::string>& folders,
                     const std::string& prefixes) {
    const std::set<std::string> inSources = quotedCodes(folders, prefixes);
    for (const diag::Explanation& explanation : explanations.all())
        EXPECT_EQ(inSources.count(explanation.code), 1U) << explanation.code << " is explained but nothing reports it";
    for (const std::string& code : inSources)
        EXPECT_NE(explanations.of(code), nullptr) << code << ": expected a file explain/" << code << ".txt";
}

void expectReadable(const diag::Explanation& explanation) {
    EXPECT_FALSE(explanation.title.empty()) << explanation.code;
    EXPECT_LT(explanation.title.size(), 60U) << explanation.code;
    EXPECT_GT(explanation.firstParagraph().size(), 80U) << explanation.code;
    std::istringstream lines(explanation.text);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100U) << explanation.code << ": " << line;
}

}  // namespace oroforge::test
