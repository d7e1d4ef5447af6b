// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "about.hpp"

#include <reporting/mcap_file/about.hpp>
#include <reporting/mcap_file/packages.hpp>
#include <rtt/deployment/deployed_texts.hpp>
#include <rtt/plugin/PluginLoader.hpp>

#include <algorithm>
#include <filesystem>
#include <string>
#include <unistd.h>

namespace OCL::recording {
namespace {

namespace mcap = oroforge::mcap;

std::string joined(std::vector<std::string> names) {
    std::sort(names.begin(), names.end());
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "" : " ") + name;
    return all;
}

mcap::Metadata aboutRecorder(const RecordingOptions& options) {
    mcap::Metadata result{"oroforge", {}};
    result.texts["component"] = options.component;
    result.texts["clock"] = options.realtime ? "realtime" : "component";
    result.texts["version"] = OROFORGE_VERSION;
    const auto plugins = RTT::plugin::PluginLoader::Instance();
    result.texts["typekits"] = joined(plugins->listTypekits());
    result.texts["plugins"] = joined(plugins->listPlugins());
    result.texts["packages"] = packagesOf(::getpid());
    // The same run in simulated time gives the same file.
    if (options.isReproducible) return result;
    result.texts.merge(aboutProcess(::getpid()));
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
    std::vector<mcap::Metadata> all{aboutRecorder(options)};
    all.push_back(aboutDeployment(options));
    if (all.back().texts.empty()) all.pop_back();
    return all;
}

}  // namespace OCL::recording
