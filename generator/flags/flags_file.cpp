// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "flags_file.hpp"

#include <cctype>
#include <fstream>
#include <set>

namespace oroforge::flags {

namespace {

bool beginsWith(const std::string& text, const std::string& start) { return text.compare(0, start.size(), start) == 0; }

bool isOldStandard(const std::string& word) {
    static const std::set<std::string> old = {"98", "03", "0x", "11", "1y", "14"};
    return old.count(word.substr(word.rfind('+') + 1)) != 0;
}

std::vector<std::string> expanded(const std::vector<std::string>& words) {
    std::vector<std::string> result;
    for (const std::string& word : words) {
        const auto parts = beginsWith(word, "SHELL:") ? splitFlags(word.substr(6)) : std::vector<std::string>{word};
        result.insert(result.end(), parts.begin(), parts.end());
    }
    return result;
}

}  // namespace

std::vector<std::string> splitFlags(const std::string& line) {
    std::vector<std::string> words;
    bool open = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool quoted = line[i] == '\\' && i + 1 < line.size();
        if (!quoted && std::isspace(static_cast<unsigned char>(line[i])) != 0) {
            open = false;
            continue;
        }
        if (!open) words.emplace_back();
        open = true;
        words.back() += quoted ? line[++i] : line[i];
    }
    return words;
}

std::vector<std::string> meaningfulFlags(const std::vector<std::string>& words) {
    const std::vector<std::string> all = expanded(words);
    std::vector<std::string> flags;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string& word = all[i];
        if (beginsWith(word, "-std=")) {
            if (!isOldStandard(word)) flags.push_back(word);
            continue;
        }
        for (const std::string option : {"-isystem", "-include", "-I", "-D", "-U"}) {
            if (!beginsWith(word, option)) continue;
            std::string value = word.substr(option.size());
            if (value.empty() && option.size() > 2 && i + 1 < all.size()) value = all[++i];
            if (!value.empty()) flags.insert(flags.end(), {option, value});
            break;
        }
    }
    return flags;
}

std::vector<std::string> readFlagsFile(const std::string& file, diag::Sink& sink) {
    std::ifstream in(file);
    if (!in) sink.error({file}, "TK008", "cannot read the compiler's options from this file");
    std::vector<std::string> words;
    for (std::string line; std::getline(in, line);) words.push_back(line);
    return meaningfulFlags(words);
}

}  // namespace oroforge::flags
