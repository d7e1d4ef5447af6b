// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "command_words.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "flags_file.hpp"

namespace fs = std::filesystem;

namespace oroforge::flags {

namespace {

bool beginsWith(const std::string& text, const std::string& start) { return text.compare(0, start.size(), start) == 0; }

std::string below(const std::string& directory, const std::string& path) {
    return (fs::path(directory) / path).lexically_normal().string();
}

/// Replaces response files by their words. `open` has the files being read, because they may include each other.
void expand(const std::vector<std::string>& words, const std::string& directory, std::vector<std::string>& open,
            std::vector<std::string>& result) {
    for (const std::string& word : words) {
        std::ifstream in;
        std::error_code ignored;
        const std::string file = word.size() > 1 && word[0] == '@' ? below(directory, word.substr(1)) : "";
        const bool isNew = !file.empty() && std::find(open.begin(), open.end(), file) == open.end();
        // Opening a folder succeeds, but reading it fails.
        if (isNew && !fs::is_directory(file, ignored)) in.open(file);
        if (in.is_open()) {
            open.push_back(file);
            expand(splitCommand(std::string(std::istreambuf_iterator<char>(in), {})), directory, open, result);
            open.pop_back();
        } else {
            result.push_back(word);
        }
    }
}

/// -include searches the working folder first, then the include folders.
std::string included(const std::string& directory, const std::string& name) {
    std::error_code ignored;
    const std::string file = below(directory, name);
    return fs::exists(file, ignored) ? file : name;
}

class Picker {
public:
    explicit Picker(const std::string& directory) : directory_(directory) {}

    std::vector<std::string> pick(const std::vector<std::string>& words) {
        for (std::size_t i = 0; i < words.size() && words[i] != "--"; ++i) {
            if (words[i] == "-Xclang" || words[i] == "-Xpreprocessor" || words[i] == "-o") {
                ++i;  // its value may look like an option
            } else if (beginsWith(words[i], "-std=") || beginsWith(words[i], "--std=")) {
                standard(words[i].substr(words[i].find('=') + 1));
            } else {
                valued(words, i);
            }
        }
        return flags_;
    }

private:
    void standard(const std::string& name) {
        if (name.find("++") == std::string::npos) return;
        const auto kept = meaningfulFlags({"-std=" + name});
        flags_.insert(flags_.end(), kept.begin(), kept.end());
    }

    void valued(const std::vector<std::string>& words, std::size_t& i) {
        for (const std::string option : {"-isystem", "-include", "-I", "-D", "-U"}) {
            const std::string& word = words[i];
            // "-include-pch" is another option, and "-includeFILE" does not exist.
            if (!beginsWith(word, option) || (option == "-include" && word != option)) continue;
            std::string value = word.substr(option.size());
            if (value.empty() && i + 1 < words.size()) value = words[++i];
            if (value.empty()) return;
            if (option[1] == 'I' || option == "-isystem") value = below(directory_, value);
            if (option == "-include") value = included(directory_, value);
            flags_.insert(flags_.end(), {option, value});
            return;
        }
    }

    const std::string& directory_;
    std::vector<std::string> flags_;
};

}  // namespace

std::vector<std::string> splitCommand(const std::string& line) {
    std::vector<std::string> words;
    bool open = false;
    char quote = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quote == 0 && std::isspace(static_cast<unsigned char>(c)) != 0) {
            open = false;
            continue;
        }
        if (!open) words.emplace_back();
        open = true;
        const char next = i + 1 < line.size() ? line[i + 1] : '\0';
        const bool escapes =
            quote == 0 || (quote == '"' && (next == '"' || next == '\\' || next == '$' || next == '`'));
        if (c == '\\' && next != '\0' && quote != '\'' && escapes) {
            words.back() += line[++i];
        } else if (quote == 0 && (c == '"' || c == '\'')) {
            quote = c;
        } else if (c == quote) {
            quote = 0;
        } else {
            words.back() += c;
        }
    }
    return words;
}

std::vector<std::string> flagsOfCommand(const std::vector<std::string>& words, const std::string& directory) {
    std::vector<std::string> all, open;
    expand(words, directory, open, all);
    return Picker(directory).pick(all);
}

std::string outputOfCommand(const std::vector<std::string>& words) {
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        if (words[i] == "-o") return words[i + 1];
    }
    return {};
}

}  // namespace oroforge::flags
