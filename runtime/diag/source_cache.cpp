// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <diag/source_cache.hpp>

#include <fstream>
#include <istream>
#include <sstream>

namespace oroforge::diag {

namespace {

std::vector<std::string> readLines(std::istream& in) {
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) {
        if (!line.empty() && line.back() == '\r') line.pop_back();
        if (lines.empty() && line.compare(0, 3, "\xEF\xBB\xBF") == 0) line.erase(0, 3);  // columns do not count it
        lines.push_back(line);
    }
    return lines;
}

}  // namespace

void SourceCache::add(const std::string& name, const std::string& text) {
    std::istringstream in(text);
    files_[name] = readLines(in);
}

const SourceCache::Lines& SourceCache::linesOf(const std::string& file) {
    const auto known = files_.find(file);
    if (known != files_.end()) return known->second;
    std::ifstream in(file);
    return files_[file] = in ? readLines(in) : Lines{};
}

const std::string* SourceCache::line(const std::string& file, unsigned number) {
    if (file.empty() || number == 0) return nullptr;
    const Lines& lines = linesOf(file);
    if (number > lines.size()) return nullptr;
    return &lines[number - 1];
}

}  // namespace oroforge::diag
