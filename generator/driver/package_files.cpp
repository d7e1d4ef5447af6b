// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <driver/package_files.hpp>

#include <algorithm>
#include <ostream>

#include <nlohmann/json.hpp>

#include <view/cpp_text.hpp>
#include <view/skeleton_view.hpp>
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

void addServiceFiles(const model::Package& package, const std::string& manifest, const render::Renderer& renderer,
                     Scaffold& files) {
    for (const auto& service : package.services) {
        const json view = view::serviceView(package, service, manifest);
        const std::string name = view::lastName(service.className.value);
        files.user["src/" + name + ".hpp"] = renderer.render("service/user.hpp", view);
        files.user["src/" + name + ".cpp"] = renderer.render("service/user.cpp", view);
        files.user["tests/" + name + "_test.cpp"] = renderer.render("service/test.cpp", view);
    }
}

/// The folder of what belongs to a service's library; the build takes its name from here.
std::string serviceFolder(const model::Package& package, const model::ServicePlugin& service) {
    return package.name.value + "/services/" + service.name.value + "/";
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
    files[directory + "reference.md"] = renderer.render("package/reference.md", view::referenceView(package, manifest));
    for (const auto& service : package.services) {
        const json view = view::serviceView(package, service, manifest);
        const std::string name = view::lastName(service.className.value);
        const std::string folder = serviceFolder(package, service);
        files[directory + name + "Base.hpp"] = renderer.render("service/base.hpp", view);
        files[folder + name + "Base.cpp"] = renderer.render("service/base.cpp", view);
        files[folder + "registration.cpp"] = renderer.render("service/registration.cpp", view);
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
    names.push_back(directory + "reference.md");
    for (const auto& service : package.services) {
        const std::string name = view::lastName(service.className.value);
        const std::string folder = serviceFolder(package, service);
        for (const std::string& file :
             {directory + name + "Base.hpp", folder + name + "Base.cpp", folder + "registration.cpp"})
            names.push_back(file);
    }
    std::sort(names.begin(), names.end());
    return names;
}

emit::Outputs skeletonFiles(const model::Package& package, const render::Renderer& renderer) {
    using model::SkeletonKind;
    emit::Outputs files;
    for (const model::Skeleton& skeleton : package.skeletons) {
        const json view = view::skeletonView(package, skeleton);
        const std::string& name = skeleton.name;
        const auto add = [&](SkeletonKind kind, const std::string& path, const char* what) {
            if (skeleton.kind == kind) files[path] = renderer.render(what, view);
        };
        add(SkeletonKind::Component, "src/" + name + "-component.hpp", "package/component.hpp");
        add(SkeletonKind::Component, "src/" + name + "-component.cpp", "package/component.cpp");
        add(SkeletonKind::Component, "tests/" + name + "-component_test.cpp", "package/component_test.cpp");
        add(SkeletonKind::Plugin, "src/" + name + "-plugin.cpp", "package/plugin.cpp");
        add(SkeletonKind::Service, "src/" + name + "-service.cpp", "package/service.cpp");
        add(SkeletonKind::Application, "src/" + name + "-application.cpp", "package/application.cpp");
        add(SkeletonKind::Support, "include/" + package.name.value + "/" + name + "-support.hpp",
            "package/support.hpp");
        add(SkeletonKind::Support, "src/" + name + "-support.cpp", "package/support.cpp");
    }
    return files;
}

Scaffold scaffold(const model::Package& package, const std::string& manifest, bool catkin,
                  const render::Renderer& renderer) {
    Scaffold files;
    json view = view::packageView(package, manifest);
    view["buildTool"] = catkin ? "catkin" : "cmake";
    if (catkin) view["isCatkin"] = true;
    const auto addShared = [&](const std::string& path, const char* what) {
        files.shared[path] = renderer.render(std::string("package/") + what, view);
    };
    addShared("CMakeLists.txt", "CMakeLists.txt");
    addShared("package.xml", "package.xml");
    addShared("README.md", "README.md");
    addShared(".clang-format", "clang-format");
    addShared(".gitignore", "gitignore");
    addShared("CMakePresets.json", "CMakePresets.json");
    addShared("colcon.pkg", "colcon.pkg");
    if (!catkin) addShared("Makefile", "Makefile");
    if (view["deployable"]) {
        addShared("deploy/" + package.name.value + ".xml", "deploy.xml");
        addShared("deploy/" + package.name.value + ".ops", "deploy.ops");
    }
    if (view["hasTests"]) addShared("tests/test_main.cpp", "test_main.cpp");
    if (!package.typekitHeaders.empty()) {
        const std::string& header = package.typekitHeaders.front().value;
        files.user[header] = renderer.render("package/types.hpp", view::typekitView(package, header));
    }
    for (const json& plugin : view["plugins"]) {
        files.user["src/" + plugin["name"].get<std::string>() + ".cpp"] = renderer.render("package/plugin.cpp", plugin);
    }
    addComponentFiles(package, manifest, renderer, files);
    addServiceFiles(package, manifest, renderer, files);
    for (const auto& [path, text] : skeletonFiles(package, renderer)) files.user[path] = text;
    return files;
}

bool writeOutputs(const emit::Outputs& outputs, const std::string& directory, bool dryRun, std::ostream& out,
                  diag::Sink& sink) {
    emit::Written written;
    if (dryRun) {
        for (const emit::Difference& one : emit::compare(outputs, directory, "orocreate-pkg"))
            written.changed.push_back(one.name);
    } else if (!emit::write(outputs, directory, sink, &written)) {
        return false;
    }
    const std::string prefix = directory == "." ? "" : directory + "/";
    for (const std::string& file : written.changed) {
        out << (dryRun ? "would write " : "wrote ") << prefix << file << '\n';
    }
    return true;
}

}  // namespace oroforge::driver
