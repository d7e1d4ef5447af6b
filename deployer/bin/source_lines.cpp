// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "source_lines.hpp"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <system_error>

namespace OCL::deploy {
namespace {

/** Offsets per call, because the length of a command line is limited. */
constexpr int kAtOnce = 1000;

/** The word, quoted for the shell. */
std::string quoted(const std::string& word) {
    std::string result = "'";
    for (const char letter : word) result += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    return result + "'";
}

std::string outputOf(const std::string& command) {
    std::FILE* const pipe = popen(command.c_str(), "re");
    if (!pipe) return {};
    std::string text;
    char part[4096];
    for (std::size_t size; (size = std::fread(part, 1, sizeof part, pipe)) != 0;) text.append(part, size);
    pclose(pipe);
    return text;
}

/** Parses "file.cpp:42 (discriminator 2)"; "??:0" and "file.cpp:?" have no line. */
oroforge::diag::Location locationOf(const std::string& text) {
    const std::size_t colon = text.rfind(':', text.rfind(" ("));
    if (colon == std::string::npos) return {};
    const unsigned line = static_cast<unsigned>(std::strtoul(text.c_str() + colon + 1, nullptr, 10));
    if (line == 0) return {};
    return {text.substr(0, colon), line, 0};
}

}  // namespace

void SourceLines::find() {
    for (auto& [file, places] : files_) ask(file, places);
}

void SourceLines::ask(const std::string& file, Places& places) {
    // The loader calls the program itself by the word with which it was started.
    std::error_code none;
    const std::string real =
        file.find('/') == std::string::npos ? std::filesystem::read_symlink("/proc/self/exe", none).string() : file;
    for (auto next = places.begin(); next != places.end();) {
        std::ostringstream command;
        command << "addr2line -aCfi -e " << quoted(real) << std::hex;
        for (int i = 0; i != kAtOnce && next != places.end(); ++i, ++next) command << " 0x" << next->first;
        command << " 2>/dev/null";
        // The offset, then function and line of each function that is inlined there, and last the function around them.
        std::istringstream answer(outputOf(command.str()));
        auto place = places.end();
        for (std::string line; std::getline(answer, line);) {
            if (line.compare(0, 2, "0x") == 0) {
                place = places.find(std::strtoul(line.c_str(), nullptr, 16));
                continue;
            }
            std::string where;
            if (!std::getline(answer, where) || place == places.end()) break;
            place->second = {line == "??" ? std::string() : line, locationOf(where)};
        }
    }
}

}  // namespace OCL::deploy
