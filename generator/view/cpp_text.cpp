// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <view/cpp_text.hpp>

#include <cctype>
#include <set>

namespace oroforge::view {

namespace {

bool containsWord(const std::string& text, const std::string& word) {
    const auto isLetter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || !isLetter(text[at - 1])) && (end == text.size() || !isLetter(text[end]))) return true;
    }
    return false;
}

}  // namespace

std::string includeName(const std::string& header, const std::string& package) {
    const std::string folder = "/include/";
    const std::string path = "/" + header;
    const std::size_t at = path.rfind(folder);
    if (at != std::string::npos) {
        const std::string name = path.substr(at + folder.size());
        if (name.find('/') != std::string::npos) return name;
    }
    const std::size_t fileAt = path.rfind('/');
    const std::string file = path.substr(fileAt + 1);
    const std::string above = path.substr(0, fileAt);
    const std::string parent = above.substr(above.rfind('/') + 1);
    const bool named = !above.empty() && parent != "include" && parent != package;
    return package + "/" + (named ? parent + "/" : "") + file;
}

std::vector<std::string> standardHeaders(const std::vector<std::string>& types) {
    static const std::pair<const char*, const char*> known[] = {
        {"std::array", "array"},       {"std::deque", "deque"},     {"std::list", "list"},   {"std::map", "map"},
        {"std::optional", "optional"}, {"std::pair", "utility"},    {"std::set", "set"},     {"std::string", "string"},
        {"std::vector", "vector"},     {"std::complex", "complex"}, {"size_t", "cstddef"},   {"int8_t", "cstdint"},
        {"uint8_t", "cstdint"},        {"int16_t", "cstdint"},      {"uint16_t", "cstdint"}, {"int32_t", "cstdint"},
        {"uint32_t", "cstdint"},       {"int64_t", "cstdint"},      {"uint64_t", "cstdint"}};
    std::set<std::string> headers;
    for (const std::string& type : types) {
        for (const auto& [name, header] : known) {
            if (containsWord(type, name)) headers.insert(header);
        }
    }
    return {headers.begin(), headers.end()};
}

std::string identifier(const std::string& packageName) {
    std::string result = packageName;
    for (char& c : result) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    }
    return result;
}

std::string className(const std::string& packageName) {
    std::string result = identifier(packageName);
    if (!result.empty()) result[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(result[0])));
    return result;
}

std::string guardName(const std::string& text) {
    std::string result = identifier(text);
    for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return result;
}

}  // namespace oroforge::view
