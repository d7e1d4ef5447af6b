// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <driver/commands.hpp>

#include <filesystem>
#include <ostream>
#include <set>

#include <nlohmann/json.hpp>

#include <check/check.hpp>
#include <driver/manifest_types.hpp>
#include <driver/package_files.hpp>
#include <emit/depfile.hpp>
#include <manifest/reader.hpp>
#include <view/view.hpp>

namespace fs = std::filesystem;

namespace oroforge::driver {

namespace {

void dumpViews(const model::Package& package, const std::string& manifest, std::ostream& out) {
    nlohmann::json all;
    all["package"] = view::packageView(package, manifest);
    all["components"] = nlohmann::json::array();
    for (const auto& component : package.components) {
        all["components"].push_back(view::componentView(package, component, manifest));
    }
    out << all.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
}

/// Reports OC012 for each file that differs from what would be written.
void checkFiles(const emit::Outputs& files, const std::string& directory, diag::Sink& sink) {
    for (const emit::Difference& one : emit::compare(files, directory, "orocreate-pkg")) {
        sink.error({(fs::path(directory) / one.name).string(), one.line, 0}, "OC012", one.message)
            .hint("orocreate-pkg --generate without --check writes it");
    }
}

}  // namespace

void generateComponents(const Options& options, const render::Renderer& renderer, std::ostream& out, diag::Sink& sink) {
    const auto package = manifest::readFile(options.generate, sink);
    if (package) check::run(*package, sink);
    if (sink.hadErrors()) return;
    const std::string manifest = fs::path(options.generate).filename().string();
    std::vector<std::string> read;
    if (options.dump.empty() && !options.listOutputs)
        read = checkTypes(*package, fs::path(options.generate).parent_path(), options.flags, sink);
    if (sink.hadErrors()) return;
    if (options.dump == "model") {
        out << model::dump(*package);
    } else if (options.dump == "view") {
        dumpViews(*package, manifest, out);
    } else if (options.listOutputs) {
        emit::listOutputs(out, generatedFileNames(*package), options.output);
    } else if (options.check) {
        checkFiles(generatedFiles(*package, manifest, renderer), options.output, sink);
    } else if (emit::writeGenerated(generatedFiles(*package, manifest, renderer), options.output, sink) &&
               !options.depfile.empty()) {
        std::vector<std::string> targets;
        if (options.depfileTarget.empty()) {
            for (const std::string& name : generatedFileNames(*package))
                targets.push_back((fs::path(options.output) / name).string());
        } else {
            targets.push_back(options.depfileTarget);
        }
        std::set<std::string> inputs{fs::absolute(options.generate).string()};
        for (const std::string& header : read) inputs.insert(fs::absolute(header).lexically_normal().string());
        emit::writeDepfile(options.depfile, targets, {inputs.begin(), inputs.end()}, sink);
    }
}

}  // namespace oroforge::driver
