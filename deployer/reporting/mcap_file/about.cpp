// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "about.hpp"

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <sys/utsname.h>

namespace OCL::recording {
namespace {

std::string dateNow() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    char text[32] = "";
    if (gmtime_r(&now, &parts)) (void)std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
    return text;
}

/** How the process was started, which names the files of its deployment. */
std::string commandLine(const std::string& process) {
    constexpr std::size_t kMost = 4096;
    std::ifstream file(process + "/cmdline", std::ios::binary);
    std::string text(kMost, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(file.gcount()));
    while (!text.empty() && text.back() == '\0') text.pop_back();
    std::replace(text.begin(), text.end(), '\0', ' ');
    return text;
}

}  // namespace

oroforge::mcap::Texts aboutProcess(pid_t process) {
    const std::string folder = "/proc/" + std::to_string(process);
    oroforge::mcap::Texts texts;
    texts["start"] = dateNow();
    texts["command"] = commandLine(folder);
    std::error_code error;
    texts["folder"] = std::filesystem::read_symlink(folder + "/cwd", error).string();
    utsname system{};
    if (::uname(&system) != 0) return texts;
    texts["host"] = system.nodename;
    texts["kernel"] = std::string(system.sysname) + " " + system.release + " " + system.machine;
    return texts;
}

std::string topicOf(std::string path) {
    std::replace(path.begin(), path.end(), '.', '/');
    return "/" + path;
}

}  // namespace OCL::recording
