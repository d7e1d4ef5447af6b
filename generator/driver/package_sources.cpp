// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <driver/package_sources.hpp>

#include <algorithm>
#include <cctype>
#include <set>

#include <emit/outputs.hpp>

namespace fs = std::filesystem;

namespace oroforge::driver {

namespace {

bool isWordLetter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// True if "class" or "struct" precedes `at`, with only blanks, names, "::" and attributes between.
bool followsClassKey(const std::string& text, std::size_t at) {
    std::size_t begin = at;
    while (begin > 0 && at - begin < 300 && std::string(";{}#").find(text[begin - 1]) == std::string::npos) --begin;
    std::string word;
    for (std::size_t i = begin; i <= at; ++i) {
        if (i < at && isWordLetter(text[i])) {
            word += text[i];
        } else {
            if (word == "class" || word == "struct") return true;
            word.clear();
        }
    }
    return false;
}

/// True for "~Plant(" and "finish (", but not "Stopped)": a definition outside a class has brackets.
bool isCallable(const std::string& text, std::size_t at) {
    while (at < text.size() && (isWordLetter(text[at]) || std::string(" \t\r\n~").find(text[at]) != std::string::npos))
        ++at;
    return at < text.size() && text[at] == '(';
}

bool hasEnding(const fs::path& file, const std::set<std::string>& endings) {
    return endings.count(file.extension().string()) != 0;
}

bool isLeftOut(const fs::path& folder) {
    const std::string name = folder.filename().string();
    std::error_code ignored;
    return name.empty() || name[0] == '.' || fs::exists(folder / "CMakeCache.txt", ignored);
}

}  // namespace

bool definesClass(const std::string& text, const std::string& name) {
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
        std::size_t end = at + name.size();
        if ((at > 0 && isWordLetter(text[at - 1])) || (end < text.size() && isWordLetter(text[end]))) continue;
        while (end < text.size() && std::isspace(static_cast<unsigned char>(text[end])) != 0) ++end;
        if ((text.compare(end, 2, "::") == 0 && isCallable(text, end + 2)) || followsClassKey(text, at)) return true;
    }
    return false;
}

PackageSources findSources(const fs::path& root, const std::vector<std::string>& classNames) {
    static const std::set<std::string> sources = {".cpp", ".cc", ".cxx", ".C"};
    static const std::set<std::string> headers = {".hpp", ".h", ".hh", ".hxx", ".H"};
    PackageSources found;
    std::error_code error;
    for (auto it = fs::recursive_directory_iterator(root, error); !error && it != fs::recursive_directory_iterator();
         it.increment(error)) {
        if (it->is_directory(error)) {
            if (isLeftOut(it->path())) it.disable_recursion_pending();
            continue;
        }
        const bool source = hasEnding(it->path(), sources);
        if (!source && !hasEnding(it->path(), headers)) continue;
        const std::string text = emit::textOf(it->path());
        const bool defines = std::any_of(classNames.begin(), classNames.end(),
                                         [&](const std::string& name) { return definesClass(text, name); });
        if (!defines) continue;
        (source ? found.sources : found.headers).push_back(it->path().lexically_relative(root).generic_string());
    }
    std::sort(found.sources.begin(), found.sources.end());
    std::sort(found.headers.begin(), found.headers.end());
    return found;
}

}  // namespace oroforge::driver
