// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <driver/package_files.hpp>

#include <algorithm>

#include <nlohmann/json.hpp>

#include <view/cpp_text.hpp>
#include <view/view.hpp>

namespace oroforge::driver {

namespace {

using nlohmann::json;

void addComponentFiles(const model::Package& package, const std::string& manifest, const render::Renderer& renderer,
                       Scaffold& files) {
    for (const auto& component : package.components) {
        const json view = view::componentView(package, component, manifest);
        const std::string name = view::lastName(component.className.value);
        files.user["src/" + name + ".hpp"] = renderer.render("component/user.hpp", view);
        files.user["src/" + name + ".cpp"] = renderer.render("component/user.cpp", view);
        files.user["tests/" + name + "_test.cpp"] = renderer.render("component/test.cpp", view);
    }
}

void addSkeletonFiles(const model::Package& package, const json& view, const render::Renderer& renderer,
                      Scaffold& files) {
    const std::string& name = package.name.value;
    const auto add = [&](bool wanted, const std::string& path, const char* what) {
        if (wanted) files.user[path] = renderer.render(what, view);
    };
    const model::Skeletons& wanted = package.skeletons;
    add(wanted.component, "src/" + name + "-component.hpp", "package/component.hpp");
    add(wanted.component, "src/" + name + "-component.cpp", "package/component.cpp");
    add(wanted.component, "tests/" + name + "-component_test.cpp", "package/component_test.cpp");
    add(wanted.plugin, "src/" + name + "-plugin.cpp", "package/plugin.cpp");
    add(wanted.service, "src/" + name + "-service.cpp", "package/service.cpp");
    add(wanted.support, "include/" + name + "/" + name + "-support.hpp", "package/support.hpp");
    add(wanted.support, "src/" + name + "-support.cpp", "package/support.cpp");
}

}  // namespace

emit::Outputs generatedFiles(const model::Package& package, const std::string& manifest,
                             const render::Renderer& renderer) {
    emit::Outputs files;
    const std::string directory = package.name.value + "/";
    for (const auto& component : package.components) {
        const json view = view::componentView(package, component, manifest);
        const std::string base = directory + view::lastName(component.className.value) + "Base";
        files[base + ".hpp"] = renderer.render("component/base.hpp", view);
        files[base + ".cpp"] = renderer.render("component/base.cpp", view);
    }
    if (!package.components.empty()) {
        files[directory + "registration.cpp"] =
            renderer.render("component/registration.cpp", view::registrationView(package, manifest));
    }
    return files;
}

std::vector<std::string> generatedFileNames(const model::Package& package) {
    std::vector<std::string> names;
    const std::string directory = package.name.value + "/";
    for (const auto& component : package.components) {
        const std::string base = directory + view::lastName(component.className.value) + "Base";
        names.push_back(base + ".hpp");
        names.push_back(base + ".cpp");
    }
    if (!names.empty()) names.push_back(directory + "registration.cpp");
    std::sort(names.begin(), names.end());
    return names;
}

Scaffold scaffold(const model::Package& package, const std::string& manifest, const render::Renderer& renderer) {
    Scaffold files;
    const json view = view::packageView(package, manifest);
    for (const char* file : {"CMakeLists.txt", "package.xml", "README.md"}) {
        files.shared[file] = renderer.render(std::string("package/") + file, view);
    }
    if (view["deployable"]) {
        files.shared["deploy/" + package.name.value + ".xml"] = renderer.render("package/deploy.xml", view);
        files.shared["tests/test_main.cpp"] = renderer.render("package/test_main.cpp", view);
    }
    if (!package.typekitHeaders.empty()) {
        const std::string& header = package.typekitHeaders.front().value;
        files.user[header] = renderer.render("package/types.hpp", view::typekitView(package, header));
    }
    addComponentFiles(package, manifest, renderer, files);
    addSkeletonFiles(package, view, renderer, files);
    return files;
}

}  // namespace oroforge::driver
