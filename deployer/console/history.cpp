// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "history.hpp"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <utility>

#include <unistd.h>

namespace OCL::console {
namespace {

constexpr std::size_t kMostLines = 1000;
constexpr const char* kName = ".tb_history";

}  // namespace

std::string historyFile() {
    if (const char* const given = std::getenv("ORO_TB_HISTFILE")) return given;
    const char* const home = std::getenv("HOME");
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

bool History::add(const std::string& line) {
    const bool blank = line.find_first_not_of(" \t") == std::string::npos;
    if (blank || line == "quit" || (!lines_.empty() && lines_.back() == line)) return false;
    if (lines_.size() == kMostLines) lines_.erase(lines_.begin());
    lines_.push_back(line);
    if (!file_.empty()) std::ofstream(file_, std::ios::app) << line << '\n';
    return true;
}

/** Replaced as a whole: another console may be reading it. */
void History::rewrite() const {
    const std::string next = file_ + "." + std::to_string(getpid());
    std::ofstream out(next);
    for (const std::string& line : lines_) out << line << '\n';
    out.close();
    if (!out || std::rename(next.c_str(), file_.c_str()) != 0) std::remove(next.c_str());
}

}  // namespace OCL::console
