// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "corpus_file.hpp"

#include <support/golden.hpp>

#include <algorithm>
#include <sstream>

namespace scripting_corpus {

namespace {

std::filesystem::path folderPath(const std::string& folder) {
    return oroforge::test::sourceRoot() / "tests/unit/scripting/corpus" / folder;
}

}  // namespace

std::vector<std::string> corpusNames(const std::string& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folderPath(folder)))
        if (entry.path().extension() == ".ops") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::filesystem::path corpusPath(const std::string& folder, const std::string& name) {
    return folderPath(folder) / (name + ".ops");
}

std::vector<std::string> expectedNotes(const std::string& script) {
    const std::string mark = "//=";
    std::vector<std::string> expected;
    std::istringstream lines(script);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t at = line.find(mark);
        if (at == std::string::npos) continue;
        const std::string text = line.substr(at + mark.size());
        expected.push_back(text.empty() || text[0] != ' ' ? text : text.substr(1));
    }
    return expected;
}

}  // namespace scripting_corpus
