// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <driver/new_classes.hpp>

#include <algorithm>

#include <driver/build_file.hpp>
#include <driver/package_files.hpp>

namespace fs = std::filesystem;

namespace oroforge::driver {

namespace {

bool isFound(const model::UserCode& code, const std::string& name) {
    return std::any_of(code.classes.begin(), code.classes.end(),
                       [&](const model::UserClass& one) { return one.name == name && !one.file.empty(); });
}

bool isSource(const std::string& file) { return file.compare(0, 4, "src/") == 0; }

/// Adds file number `i` of a class after the same file of another class.
bool addFile(std::string& cmake, std::size_t i, const NewClasses& input, const merge::WantedClass& wanted) {
    const auto others = [&](const merge::WantedClass& other) {
        return other.isComponent && other.name != wanted.name &&
               addBehind(cmake, classFileNames(other.name, true)[i], classFileNames(wanted.name, true)[i]);
    };
    return wanted.isComponent && std::any_of(input.wanted.rbegin(), input.wanted.rend(), others);
}

void addToBuild(const NewClasses& input, const merge::WantedClass& wanted, const std::vector<std::string>& files,
                emit::Outputs& outputs, merge::Plan& plan, diag::Sink& sink) {
    if (outputs.count(kBuildFile) == 0) outputs[kBuildFile] = emit::textOf(input.root / kBuildFile);
    std::string& cmake = outputs[kBuildFile];
    for (std::size_t i = 0; i != files.size(); ++i) {
        const bool added = addFile(cmake, i, input, wanted);
        if (!isSource(files[i]) || fs::path(files[i]).extension() != ".cpp") continue;
        if (added) {
            plan.changes.push_back(std::string(kBuildFile) + ": " + files[i]);
        } else {
            sink.warning({input.shown + kBuildFile, 0, 0}, "OC041",
                         "no place for '" + files[i] + "' was found: it is to be added by hand")
                .note(wanted.where, "of the class that is new here");
        }
    }
    if (cmake.empty()) outputs.erase(kBuildFile);
}

}  // namespace

void addNewClasses(const NewClasses& input, const render::Renderer& renderer, emit::Outputs& outputs, merge::Plan& plan,
                   diag::Sink& sink) {
    const Scaffold all = scaffold(input.package, input.manifest, false, renderer);
    for (const merge::WantedClass& wanted : input.wanted) {
        if (isFound(input.code, wanted.name)) continue;
        const auto recorded = input.record.find(wanted.name);
        if (recorded != input.record.end()) {
            plan.record[wanted.name] = recorded->second;
            sink.warning(wanted.where, "OC034",
                         "class '" + wanted.name + "' was once in this package and is not found any more")
                .hint("if it has another name now, change the manifest, too");
            continue;
        }
        const std::vector<std::string> files = classFileNames(wanted.name, wanted.isComponent);
        for (const std::string& file : files) {
            if (emit::exists(input.root / file)) {
                if (isSource(file))
                    sink.error({input.shown + file, 0, 0}, "OC030",
                               "this file is there already, but class '" + wanted.name + "' was not found in it")
                        .note(wanted.where, "the manifest wants it here");
                continue;
            }
            const std::string& text = all.user.at(file);
            outputs[file] = input.format(file, text, {{0, text.size()}}).front();
            plan.changes.push_back(file + ": new");
        }
        plan.record[wanted.name] = merge::recordOf(wanted);
        addToBuild(input, wanted, files, outputs, plan, sink);
    }
}

}  // namespace oroforge::driver
