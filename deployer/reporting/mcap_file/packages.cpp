// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "packages.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

namespace OCL::recording {
namespace {

namespace fs = std::filesystem;

std::set<std::string> librariesOf(pid_t process) {
    std::set<std::string> files;
    std::ifstream maps("/proc/" + std::to_string(process) + "/maps");
    for (std::string line; std::getline(maps, line);) {
        const std::size_t path = line.find('/');
        if (path != std::string::npos && line.find(".so", path) != std::string::npos) files.insert(line.substr(path));
    }
    return files;
}

/** Empty if there is no such file, or it names no version. */
std::string versionIn(const fs::path& pkgConfig) {
    const std::string key = "Version:";
    std::ifstream file(pkgConfig);
    for (std::string line; std::getline(file, line);) {
        if (line.compare(0, key.size(), key) != 0) continue;
        const std::size_t begin = line.find_first_not_of(" \t", key.size());
        return begin == std::string::npos ? "" : line.substr(begin, line.find_last_not_of(" \t\r") + 1 - begin);
    }
    return "";
}

/** Adds the package of "PREFIX/lib/orocos/gnulinux/tank/libtank-gnulinux.so", whose description is
    "PREFIX/lib/pkgconfig/tank-gnulinux.pc". */
void addPackageOf(const std::string& library, std::map<std::string, std::string>& versions) {
    const std::string folder = "/orocos/";
    const std::size_t at = library.rfind(folder);
    if (at == std::string::npos) return;
    const std::string file = fs::path(library).filename().string(), stem = file.substr(0, file.find(".so"));
    const std::string target = stem.substr(std::min(stem.rfind('-') + 1, stem.size()));
    const fs::path below = fs::path(library.substr(at + folder.size())).parent_path();
    for (const fs::path& part : below) {
        const std::string name = part.string();
        // The toolchain's own, whose version is that of the recorder.
        if (name == "types" || name == "plugins") return;
        // The folder of the target is left out for some, among them the packages of ROS.
        if (name == target) continue;
        versions[name] = versionIn(fs::path(library.substr(0, at)) / "pkgconfig" / (name + "-" + target + ".pc"));
        return;
    }
}

}  // namespace

std::string packagesOf(pid_t process) {
    std::map<std::string, std::string> versions;
    for (const std::string& library : librariesOf(process)) addPackageOf(library, versions);
    std::string text;
    for (const auto& [name, version] : versions)
        text += (text.empty() ? "" : ", ") + name + (version.empty() ? "" : " " + version);
    return text;
}

}  // namespace OCL::recording
