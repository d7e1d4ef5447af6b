// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "history.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace OCL::console {
namespace {

constexpr std::size_t kMostLines = 1000;
constexpr const char* kName = ".tb_history";

}  // namespace

std::string fileNamedBy(const char* variable) {
    const char* const home = std::getenv("HOME");
    const char* const given = std::getenv(variable);
    if (!given) return "";
    return home && std::strncmp(given, "~/", 2) == 0 ? home + std::string(given + 1) : given;
}

std::string historyFile() {
    const char* const home = std::getenv("HOME");
    if (std::getenv("ORO_TB_HISTFILE")) return fileNamedBy("ORO_TB_HISTFILE");
    const bool here = access(kName, F_OK) == 0 ? access(kName, W_OK) == 0 : access(".", W_OK) == 0;
    return here || !home ? kName : std::string(home) + "/" + kName;
}

History::History(std::string file) : file_(std::move(file)) {
    std::ifstream in(file_);
    for (std::string line; std::getline(in, line);)
        if (!line.empty()) lines_.push_back(line);
    if (lines_.size() <= kMostLines) return;
    lines_.erase(lines_.begin(), lines_.end() - kMostLines);
    rewrite();
}

std::string History::problem() const {
    if (file_.empty()) return {};
    const int found = open(file_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
    if (found >= 0) {
        close(found);
        return {};
    }
    const std::string folder = std::filesystem::path(file_).parent_path().string();
    if (errno == ENOENT && access(folder.empty() ? "." : folder.c_str(), W_OK) == 0) return {};
    return file_ + ": what is typed is not kept: " + std::strerror(errno);
}

bool History::add(const std::string& line) {
    const bool blank = line.find_first_not_of(" \t") == std::string::npos;
    if (blank || line == "quit" || (!lines_.empty() && lines_.back() == line)) return false;
    if (lines_.size() == kMostLines) lines_.erase(lines_.begin());
    lines_.push_back(line);
    if (!file_.empty()) std::ofstream(file_, std::ios::app) << line << '\n';
    return true;
}

/** Replaces the file as a whole, because another console may be reading it. A link to it and its permissions stay. */
void History::rewrite() const {
    std::error_code ignored;
    const std::filesystem::path real = std::filesystem::canonical(file_, ignored);
    const std::string file = real.empty() ? file_ : real.string();
    const std::string next = file + "." + std::to_string(getpid());
    std::ofstream out(next);
    std::filesystem::permissions(next, std::filesystem::status(file, ignored).permissions(), ignored);
    for (const std::string& line : lines_) out << line << '\n';
    out.close();
    if (!out || std::rename(next.c_str(), file.c_str()) != 0) std::remove(next.c_str());
}

}  // namespace OCL::console
