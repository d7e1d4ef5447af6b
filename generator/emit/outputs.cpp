// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <emit/outputs.hpp>

#include <fstream>
#include <iterator>
#include <ostream>
#include <set>
#include <sstream>

#include <emit/banner.hpp>
#include <emit/transaction.hpp>
#include <files/draft_file.hpp>

namespace fs = std::filesystem;

namespace oroforge::emit {

std::string textOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

bool exists(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(path, ignored);
}

bool isFile(const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

namespace {

bool hasText(const fs::path& file, const std::string& text) { return isFile(file) && textOf(file) == text; }

/// True if a file exists that was not generated. An empty file has nothing to lose.
bool isForeign(const fs::path& file) {
    if (!isFile(file)) return false;
    const std::string text = textOf(file);
    return !text.empty() && !hasBanner(text);
}

/// Removes what other processes left beside these files when they died.
void removeAbandoned(const Outputs& outputs, const fs::path& directory) {
    std::map<fs::path, std::set<std::string>> folders;
    for (const auto& [name, text] : outputs) {
        const fs::path target = directory / name;
        folders[target.parent_path()].insert(target.filename().string());
    }
    for (const auto& [folder, names] : folders) files::removeAbandoned(folder, names);
}

/// Finds the first line that differs, and the expected line.
Difference differenceOf(const std::string& found, const std::string& expected, const std::string& tool) {
    std::istringstream one(found), other(expected);
    std::string line, wanted;
    for (unsigned number = 1;; ++number) {
        const bool more = static_cast<bool>(std::getline(one, line));
        const bool due = static_cast<bool>(std::getline(other, wanted));
        if (more && due && line == wanted) continue;
        if (more && due && line == wanted + "\r") return {"", number, "stale: lines end with CR LF, expected LF"};
        if (more && due) return {"", number, "stale: " + tool + " now writes '" + wanted + "' here"};
        if (due) return {"", number, "stale: the file ends before the line '" + wanted + "'"};
        return {"", more ? number : 0, "stale: " + tool + " now writes fewer lines"};
    }
}

}  // namespace

bool write(const Outputs& outputs, const fs::path& directory, diag::Sink& sink, Written* written) {
    removeAbandoned(outputs, directory);
    Transaction transaction(sink);
    Written result;
    for (const auto& [name, text] : outputs) {
        const fs::path target = directory / name;
        if (hasText(target, text)) {
            result.unchanged.push_back(name);
            continue;
        }
        if (!transaction.stage(target, text)) return false;
        result.changed.push_back(name);
    }
    if (!transaction.commit()) return false;
    if (written != nullptr) *written = result;
    return true;
}

std::vector<Difference> compare(const Outputs& outputs, const fs::path& directory, const std::string& tool) {
    std::vector<Difference> result;
    for (const auto& [name, text] : outputs) {
        if (!isFile(directory / name)) {
            result.push_back({name, 0, "missing: " + tool + " would write this file"});
        } else if (const std::string found = textOf(directory / name); found != text) {
            result.push_back(differenceOf(found, text, tool));
            result.back().name = name;
        }
    }
    return result;
}

bool writeGenerated(const Outputs& outputs, const fs::path& directory, diag::Sink& sink, Written* written) {
    for (const auto& [name, text] : outputs) {
        if (!hasBanner(text) || !isForeign(directory / name)) continue;
        sink.error({(directory / name).string()}, "EMIT002", "this file was not generated; it would be written over")
            .hint("choose another output folder, or another build folder, or remove the file");
        return false;
    }
    return write(outputs, directory, sink, written);
}

void listOutputs(std::ostream& out, const Outputs& outputs, const fs::path& directory) {
    for (const auto& entry : outputs) out << (directory / entry.first).string() << '\n';
}

void listOutputs(std::ostream& out, const std::vector<std::string>& outputs, const fs::path& directory) {
    for (const std::string& name : outputs) out << (directory / name).string() << '\n';
}

}  // namespace oroforge::emit
