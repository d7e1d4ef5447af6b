// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "about.hpp"

#include <rtt/deployment/deployed_texts.hpp>
#include <rtt/plugin/PluginLoader.hpp>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/utsname.h>
#include <system_error>

namespace OCL::recording {
namespace {

namespace mcap = oroforge::mcap;

std::string dateNow() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    char text[32] = "";
    if (gmtime_r(&now, &parts)) (void)std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
    return text;
}

/** How the process was started, which names the files of its deployment. */
std::string commandLine() {
    constexpr std::size_t kMost = 4096;
    std::ifstream file("/proc/self/cmdline", std::ios::binary);
    std::string text(kMost, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(file.gcount()));
    while (!text.empty() && text.back() == '\0') text.pop_back();
    std::replace(text.begin(), text.end(), '\0', ' ');
    return text;
}

std::string joined(std::vector<std::string> names) {
    std::sort(names.begin(), names.end());
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "" : " ") + name;
    return all;
}

mcap::Metadata aboutProcess(const RecordingOptions& options) {
    mcap::Metadata result{"oroforge", {}};
    result.texts["component"] = options.component;
    result.texts["clock"] = options.realtime ? "realtime" : "component";
    result.texts["version"] = OROFORGE_VERSION;
    const auto plugins = RTT::plugin::PluginLoader::Instance();
    result.texts["typekits"] = joined(plugins->listTypekits());
    result.texts["plugins"] = joined(plugins->listPlugins());
    // The same run in simulated time gives the same file.
    if (options.isReproducible) return result;
    result.texts["start"] = dateNow();
    result.texts["command"] = commandLine();
    std::error_code error;
    result.texts["folder"] = std::filesystem::current_path(error).string();
    utsname system{};
    if (::uname(&system) != 0) return result;
    result.texts["host"] = system.nodename;
    result.texts["kernel"] = std::string(system.sysname) + " " + system.release + " " + system.machine;
    return result;
}

/** The files of the deployment, by their names. */
mcap::Metadata aboutDeployment(const RecordingOptions& options) {
    mcap::Metadata result{"oroforge.deployment", {}};
    for (const RTT::plugin::DeployedText& one : RTT::plugin::deployedTexts()) {
        // The same deployment may be in another folder.
        std::string name = options.isReproducible ? std::filesystem::path(one.file).filename().string() : one.file;
        while (result.texts.count(name) != 0) name += "'";
        result.texts[name] = one.text;
    }
    return result;
}

}  // namespace

std::vector<mcap::Metadata> aboutRecording(const RecordingOptions& options) {
    std::vector<mcap::Metadata> all{aboutProcess(options)};
    all.push_back(aboutDeployment(options));
    if (all.back().texts.empty()) all.pop_back();
    return all;
}

}  // namespace OCL::recording
