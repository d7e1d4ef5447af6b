// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <driver/commands.hpp>

#include <filesystem>
#include <ostream>
#include <regex>

#include <nlohmann/json.hpp>

#include <check/check.hpp>
#include <driver/build_file.hpp>
#include <driver/kinds.hpp>
#include <driver/package_files.hpp>
#include <merge/text_places.hpp>
#include <view/cpp_text.hpp>
#include <view/skeleton_view.hpp>
#include <view/view.hpp>

namespace fs = std::filesystem;

namespace oroforge::driver {

namespace {

const diag::Location kHere{"orocreate-pkg", 0, 0};

/// Files that must not exist yet, and additions to the build file.
struct Additions {
    emit::Outputs files;
    std::string targets;  ///< for CMakeLists.txt
    std::string header;   ///< to be listed by orocos_typegen_headers()
};

std::string withTargets(const std::string& cmake, const Additions& additions, diag::Sink& sink) {
    std::string text = cmake;
    std::string targets = additions.targets;
    if (!additions.header.empty()) {
        if (const auto call = findCommand(text, "orocos_typegen_headers")) {
            text.insert(endOfNames(text, *call), " " + additions.header);
        } else {
            targets = "\norocos_typegen_headers(" + additions.header + ")\n";
        }
        targets += "\norocos_install_headers(" + additions.header + ")\n";
    }
    const auto last = findCommand(text, "orocos_generate_package");
    if (!last) {
        sink.error({kBuildFile, 0, 0}, "OC011",
                   "there is no orocos_generate_package() before which the target could go")
            .hint("these lines are to be added by hand:" + targets);
        return cmake;
    }
    // The block begins with an empty line; that line goes after it, before the command.
    std::string block = targets.substr(targets.find_first_not_of('\n')) + "\n";
    block = std::regex_replace(block, std::regex("\n"), merge::lineEndOf(text));
    text.insert(last->begin, block);
    return text;
}

Additions additionsFor(const std::string& package, const Options& options, const render::Renderer& renderer) {
    const std::string& kind = options.add[0];
    const std::string& name = options.add[1];
    model::Package part;
    part.name = {package, {kHere.file, 1, 1}};
    Additions additions;
    if (kind == "typekit") {
        additions.header = typekitHeader(package, name);
        nlohmann::json view = view::typekitView(part, additions.header);
        view["class"] = view::className(name);
        additions.files[additions.header] = renderer.render("package/types.hpp", view);
        return additions;
    }
    part.skeletons.push_back(*skeletonOf(kind, name, options));
    additions.files = skeletonFiles(part, renderer);
    if (part.skeletons.front().kind == model::SkeletonKind::Component && !emit::exists("tests/test_main.cpp")) {
        additions.files["tests/test_main.cpp"] = renderer.render("package/test_main.cpp", nlohmann::json::object());
    }
    additions.targets = renderer.render("package/targets", view::skeletonsView(part));
    return additions;
}

}  // namespace

void addPart(const Options& options, const render::Renderer& renderer, std::ostream& out, diag::Sink& sink) {
    static const std::vector<std::string> known = {"component", "service", "plugin",
                                                   "support",   "typekit", "application"};
    checkKind(options.add[0], known, sink);
    const std::string fault = check::packageNameFault(options.add[1]);
    if (!fault.empty()) sink.error(kHere, "OC002", "name '" + options.add[1] + "' " + fault);
    checkNames(options, sink);
    const std::string cmake = emit::textOf(kBuildFile);
    const auto project = findCommand(cmake, "project");
    if (!project) {
        sink.error(kHere, "OC009",
                   "no package here: expected a CMakeLists.txt with project() in the current directory");
    }
    if (project && !check::packageNameFault(project->first).empty()) {
        sink.error({kBuildFile, 0, 0}, "OC009",
                   "the package is named '" + project->first + "' by project(); expected a plain name there");
    }
    if (sink.hadErrors()) return;

    Additions additions = additionsFor(project->first, options, renderer);
    for (const auto& [file, text] : additions.files) {
        if (emit::exists(file)) sink.error({file, 0, 0}, "OC010", "the file is there already; nothing was written");
    }
    additions.files[kBuildFile] = withTargets(cmake, additions, sink);
    if (!sink.hadErrors()) writeOutputs(additions.files, ".", options.dryRun, out, sink);
}

}  // namespace oroforge::driver
