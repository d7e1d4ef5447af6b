// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <plan/sources.hpp>

#include <algorithm>
#include <filesystem>
#include <set>

#include <plan/cpp_words.hpp>
#include <plan/library_view.hpp>
#include <plan/type_needs.hpp>

namespace fs = std::filesystem;

namespace oroforge::typekit {

namespace {

constexpr std::size_t kLongestWord = 120;  // a file name has 255 bytes at most

/// Makes a header's name from its end: it includes more folders until no other header has the same name.
struct HeaderName {
    std::vector<std::string> parts;
    std::string extension;
    std::size_t used = 1;

    explicit HeaderName(const fs::path& include) : extension(cppLetters(include.extension().string())) {
        for (const fs::path& folder : include.parent_path()) parts.push_back(cppLetters(folder.string()));
        parts.push_back(cppLetters(include.stem().string()));
    }
    std::string word() const {
        std::string text;
        for (std::size_t i = parts.size() - std::min(used, parts.size()); i != parts.size(); ++i)
            text += (text.empty() ? "" : "_") + parts[i];
        if (used > parts.size()) text += extension;
        return text.size() > kLongestWord ? text.substr(text.size() - kLongestWord) : text;
    }
    bool canGrow() const { return used <= parts.size(); }
};

std::vector<std::string> wordsOf(const std::vector<model::Header>& headers) {
    std::vector<HeaderName> names;
    for (const model::Header& header : headers) names.emplace_back(header.include);
    std::vector<std::string> words(names.size());
    for (bool grown = true; grown;) {
        std::map<std::string, std::size_t> count;
        for (std::size_t i = 0; i != names.size(); ++i) ++count[words[i] = names[i].word()];
        grown = false;
        for (std::size_t i = 0; i != names.size(); ++i) {
            if (count[words[i]] == 1 || !names[i].canGrow()) continue;
            ++names[i].used;
            grown = true;
        }
    }
    return words;
}

std::string unused(const std::string& word, std::set<std::string>& taken) {
    std::string name = word;
    for (std::size_t number = 2; !taken.insert(name).second; ++number) name = word + "_" + std::to_string(number);
    return name;
}

template <class Types>
std::vector<std::string> namesOf(const Types& types) {
    std::vector<std::string> names;
    for (const auto& type : types) names.push_back(type.name);
    return names;
}

}  // namespace

std::vector<Source> sourcesOf(const std::vector<model::Header>& headers) {
    const std::vector<std::string> words = wordsOf(headers);
    std::vector<Source> sources;
    std::set<std::string> taken;
    for (std::size_t header = 0; header != headers.size(); ++header) {
        if (headers[header].pieces < 2) sources.push_back({header, unused(words[header], taken)});
        for (std::size_t piece = 1; headers[header].pieces > 1 && piece <= headers[header].pieces; ++piece)
            sources.push_back({header, unused(words[header] + "_" + std::to_string(piece), taken)});
    }
    return sources;
}

Placement::Placement(const model::TypeModel& model, const TypeNeeds& needs) : sources_(sourcesOf(model.headers)) {
    deal(namesOf(model.structs), needs);
    deal(namesOf(model.enums), needs);
    deal(namesOf(model.adapted), needs);
    std::vector<std::string> library, arrays;
    for (const model::TypeUse& use : model.library) {
        library.push_back(use.name);
        if (use.kind == model::TypeKind::Map) library.push_back(entryName(use));
    }
    for (const model::TypeUse& use : model.arrays) arrays.push_back(model::arrayName(use));
    deal(library, needs);
    deal(arrays, needs);
}

std::size_t Placement::of(const std::string& name) const {
    const auto found = places_.find(name);
    return found == places_.end() ? 0 : found->second;
}

void Placement::deal(const std::vector<std::string>& names, const TypeNeeds& needs) {
    std::map<std::size_t, std::vector<std::string>> ofHeader;
    for (const std::string& name : names) ofHeader[needs.homeOf(name)].push_back(name);
    for (const auto& [header, own] : ofHeader) {
        const auto isOfHeader = [home = header](const Source& source) { return source.header == home; };
        const auto first = std::find_if(sources_.begin(), sources_.end(), isOfHeader);
        const auto pieces = static_cast<std::size_t>(std::count_if(first, sources_.end(), isOfHeader));
        const auto start = static_cast<std::size_t>(first - sources_.begin());
        for (std::size_t i = 0; i != own.size(); ++i) places_[own[i]] = start + i * pieces / own.size();
    }
}

}  // namespace oroforge::typekit
