// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <messages/package_search.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include <emit/outputs.hpp>

namespace fs = std::filesystem;

namespace oroforge::messages {

namespace {

constexpr int kDeepest = 20;  // links may make circles

std::vector<std::string> listOf(const char* variable) {
    std::vector<std::string> parts;
    const char* const value = std::getenv(variable);
    std::string part;
    for (const char* c = value ? value : ""; *c != '\0'; ++c) {
        if (*c == ':' || *c == ';') {
            if (!part.empty()) parts.push_back(part);
            part.clear();
        } else {
            part += *c;
        }
    }
    if (!part.empty()) parts.push_back(part);
    return parts;
}

/// The text of <name>, as far as package.xml can be read without a parser.
std::string nameIn(const fs::path& file) {
    const std::string text = emit::textOf(file);
    const std::size_t open = text.find("<name>"), close = text.find("</name>", open);
    if (close == std::string::npos) return "";
    const std::string name = text.substr(open + 6, close - open - 6);
    const std::size_t first = name.find_first_not_of(" \t\r\n");
    return first == std::string::npos ? "" : name.substr(first, name.find_last_not_of(" \t\r\n") - first + 1);
}

void addOnce(std::vector<std::string>& list, const std::string& one) {
    if (std::find(list.begin(), list.end(), one) == list.end()) list.push_back(one);
}

}  // namespace

PackageSearch::PackageSearch() : workspaces_(listOf("ROS_PACKAGE_PATH")) {
    for (const std::string& prefix : listOf("CMAKE_PREFIX_PATH")) shares_.push_back(prefix + "/share");
    shares_.emplace_back("/usr/share");
}

void PackageSearch::add(const std::string& package, const std::string& folder) { addOnce(added_[package], folder); }

void PackageSearch::crawl(const std::string& folder, int depth) {
    const fs::path at(folder);
    if (depth > kDeepest || emit::exists(at / "CATKIN_IGNORE") || emit::exists(at / "rospack_nosubdirs")) return;
    if (emit::exists(at / "package.xml") || emit::exists(at / "manifest.xml")) {
        const std::string name = nameIn(at / "package.xml");
        addOnce(crawled_[name.empty() ? at.filename().string() : name], folder);
        return;
    }
    std::error_code error;
    std::vector<std::string> below;
    for (const fs::directory_entry& entry : fs::directory_iterator(at, error))
        if (entry.is_directory(error) && entry.path().filename().string()[0] != '.')
            below.push_back(entry.path().string());
    std::sort(below.begin(), below.end());
    for (const std::string& next : below) crawl(next, depth + 1);
}

const std::vector<std::string>& PackageSearch::roots(const std::string& package) {
    const auto known = roots_.find(package);
    if (known != roots_.end()) return known->second;
    std::vector<std::string>& found = roots_[package];
    if (!hasCrawled_)
        for (const std::string& folder : workspaces_) crawl(folder, 0);
    hasCrawled_ = true;
    found = crawled_[package];
    for (const std::string& share : shares_)
        if (emit::exists(fs::path(share) / package)) addOnce(found, share + "/" + package);
    return found;
}

std::vector<std::string> PackageSearch::foldersOf(const std::string& package, const std::string& kind) {
    std::vector<std::string> folders;
    if (kind == "msg") folders = added_[package];
    for (const std::string& root : roots(package))
        if (emit::exists(fs::path(root) / kind)) addOnce(folders, root + "/" + kind);
    return folders;
}

std::string PackageSearch::folderOf(const std::string& package) {
    for (const std::string& root : roots(package))
        if (emit::exists(fs::path(root) / "package.xml") || emit::exists(fs::path(root) / "manifest.xml")) return root;
    return "";
}

std::string PackageSearch::described() const {
    std::string text;
    for (const auto* list : {&workspaces_, &shares_})
        for (const std::string& folder : *list) text += (text.empty() ? "" : ", ") + folder;
    return text;
}

}  // namespace oroforge::messages
