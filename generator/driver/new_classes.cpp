// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <driver/new_classes.hpp>

#include <algorithm>

#include <driver/build_file.hpp>
#include <driver/package_files.hpp>
#include <view/cpp_text.hpp>

namespace fs = std::filesystem;

namespace oroforge::driver {

namespace {

bool isFound(const model::UserCode& code, const std::string& name) {
    return std::any_of(code.classes.begin(), code.classes.end(),
                       [&](const model::UserClass& one) { return one.name == name && !one.file.empty(); });
}

void addToBuild(const NewClasses& input, const merge::WantedClass& wanted, emit::Outputs& outputs, merge::Plan& plan,
                diag::Sink& sink) {
    const std::string name = view::lastName(wanted.name);
    if (outputs.count(kBuildFile) == 0) outputs[kBuildFile] = emit::textOf(input.root / kBuildFile);
    std::string& cmake = outputs[kBuildFile];
    bool source = false, header = false, test = false;
    for (auto other = input.wanted.rbegin(); other != input.wanted.rend() && wanted.isComponent; ++other) {
        if (!other->isComponent || other->name == wanted.name) continue;
        const std::string known = view::lastName(other->name);
        source = source || addBehind(cmake, "src/" + known + ".cpp", "src/" + name + ".cpp");
        if (!header) header = addBehind(cmake, "src/" + known + ".hpp", "src/" + name + ".hpp");
        test = test || addBehind(cmake, "tests/" + known + "_test.cpp", "tests/" + name + "_test.cpp");
    }
    if (source) plan.changes.push_back(std::string(kBuildFile) + ": src/" + name + ".cpp");
    if (cmake.empty()) outputs.erase(kBuildFile);
    if (source) return;
    sink.warning({input.shown + kBuildFile, 0, 0}, "OC041",
                 "no place for 'src/" + name + ".cpp' was found: it is to be added by hand")
        .note(wanted.where, "of the class that is new here");
}

}  // namespace

void addNewClasses(const NewClasses& input, const render::Renderer& renderer, emit::Outputs& outputs, merge::Plan& plan,
                   diag::Sink& sink) {
    const Scaffold all = scaffold(input.package, input.manifest, false, renderer);
    for (const merge::WantedClass& wanted : input.wanted) {
        if (isFound(input.code, wanted.name)) continue;
        const std::string name = view::lastName(wanted.name);
        const auto recorded = input.record.find(wanted.name);
        if (recorded != input.record.end()) {
            plan.record[wanted.name] = recorded->second;
            sink.warning(wanted.where, "OC034",
                         "class '" + wanted.name + "' was once in this package and is not found any more")
                .hint("if it has another name now, change the manifest, too");
            continue;
        }
        for (const std::string& file :
             {"src/" + name + ".hpp", "src/" + name + ".cpp", "tests/" + name + "_test.cpp"}) {
            if (emit::exists(input.root / file)) {
                if (file.compare(0, 4, "src/") == 0)
                    sink.error({input.shown + file, 0, 0}, "OC030",
                               "this file is there already, but class '" + wanted.name + "' was not found in it")
                        .note(wanted.where, "the manifest wants it here");
                continue;
            }
            outputs[file] = all.user.at(file);
            plan.changes.push_back(file + ": new");
        }
        plan.record[wanted.name] = merge::recordOf(wanted);
        addToBuild(input, wanted, outputs, plan, sink);
    }
}

}  // namespace oroforge::driver
