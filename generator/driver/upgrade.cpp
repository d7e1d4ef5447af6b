// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <driver/commands.hpp>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <regex>

#include <driver/package_files.hpp>

namespace fs = std::filesystem;

namespace oroforge::driver {

namespace {

std::vector<fs::path> manifestsBelow(const fs::path& folder) {
    std::vector<fs::path> found;
    std::error_code error;
    for (fs::recursive_directory_iterator it(folder, fs::directory_options::skip_permission_denied, error), end;
         !error && it != end; it.increment(error)) {
        if (it->path().filename() == "manifest.xml" && it->is_regular_file()) found.push_back(it->path());
    }
    std::sort(found.begin(), found.end());
    return found;
}

/// Changes only the names of elements and attributes; comments and blanks stay.
std::string upgraded(const std::string& manifest) {
    static const std::regex depend(
        "<depend(\\s+)package(\\s*=\\s*[\"'](rtt|ocl|orogen|utilrb|utilmm|typelib|rtt_typelib|log4cpp)[\"'])");
    return std::regex_replace(manifest, depend, "<rosdep$1name$2");
}

}  // namespace

void upgradePackages(const Options& options, std::ostream& out, diag::Sink& sink) {
    emit::Outputs outputs;
    for (const std::string& folder : options.words) {
        const std::vector<fs::path> manifests = manifestsBelow(folder);
        if (manifests.empty()) {
            sink.error({folder, 0, 0}, "OC013", "no manifest.xml in this folder or below it");
        }
        for (const fs::path& manifest : manifests) {
            const std::string before = emit::textOf(manifest);
            const std::string after = upgraded(before);
            if (after == before) continue;
            outputs[manifest.string()] = after;
            if (!options.force) outputs[manifest.string() + ".old"] = before;
        }
    }
    if (!sink.hadErrors()) writeOutputs(outputs, ".", options.dryRun, out, sink);
}

}  // namespace oroforge::driver
