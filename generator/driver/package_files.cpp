// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <driver/package_files.hpp>

#include <algorithm>
#include <ostream>

#include <nlohmann/json.hpp>

#include <model/names.hpp>
#include <render/output_table.hpp>
#include <view/skeleton_view.hpp>
#include <view/view.hpp>

namespace oroforge::driver {

namespace {

using nlohmann::json;
using render::Owner;
using render::Subject;

/// The files of a package: their subject, owner, path and template.
const render::OutputTable kOutputs = {
    {"component", Owner::Generated, "{package}/{class}Base.hpp", "component/base.hpp"},
    {"component", Owner::Generated, "{package}/{class}Base.cpp", "component/base.cpp"},
    {"component", Owner::User, "src/{class}.hpp", "component/user.hpp"},
    {"component", Owner::User, "src/{class}.cpp", "component/user.cpp"},
    {"component", Owner::User, "tests/{class}_test.cpp", "component/test.cpp"},
    {"registration", Owner::Generated, "{package}/registration.cpp", "component/registration.cpp"},
    {"reference", Owner::Generated, "{package}/reference.md", "package/reference.md"},
    // The build names a service's library after the folder.
    {"service", Owner::Generated, "{package}/{class}Base.hpp", "service/base.hpp"},
    {"service", Owner::Generated, "{package}/services/{name}/{class}Base.cpp", "service/base.cpp"},
    {"service", Owner::Generated, "{package}/services/{name}/registration.cpp", "service/registration.cpp"},
    {"service", Owner::User, "src/{class}.hpp", "service/user.hpp"},
    {"service", Owner::User, "src/{class}.cpp", "service/user.cpp"},
    {"service", Owner::User, "tests/{class}_test.cpp", "service/test.cpp"},
    {"package", Owner::Shared, "CMakeLists.txt", "package/CMakeLists.txt"},
    {"package", Owner::Shared, "package.xml", "package/package.xml"},
    {"package", Owner::Shared, "README.md", "package/README.md"},
    {"package", Owner::Shared, ".clang-format", "package/clang-format"},
    {"package", Owner::Shared, ".gitignore", "package/gitignore"},
    {"package", Owner::Shared, "CMakePresets.json", "package/CMakePresets.json"},
    {"package", Owner::Shared, "colcon.pkg", "package/colcon.pkg"},
    {"package built alone", Owner::Shared, "Makefile", "package/Makefile"},
    {"deployment", Owner::Shared, "deploy/{package}.xml", "package/deploy.xml"},
    {"deployment", Owner::Shared, "deploy/{package}.ops", "package/deploy.ops"},
    {"tests", Owner::Shared, "tests/test_main.cpp", "package/test_main.cpp"},
    {"typekit", Owner::User, "{name}", "package/types.hpp"},
    {"plugin", Owner::User, "src/{name}.cpp", "package/plugin.cpp"},
    {"new components", Owner::User, "src/{name}-component.hpp", "package/component.hpp"},
    {"new components", Owner::User, "src/{name}-component.cpp", "package/component.cpp"},
    {"new components", Owner::User, "tests/{name}-component_test.cpp", "package/component_test.cpp"},
    {"new topics", Owner::User, "src/{name}-topics.hpp", "package/topics.hpp"},
    {"new topics", Owner::User, "src/{name}-topics.cpp", "package/topics.cpp"},
    {"new topics", Owner::User, "tests/{name}-topics_test.cpp", "package/topics_test.cpp"},
    {"new topics", Owner::User, "deploy/{name}-topics.ops", "package/topics.ops"},
    {"new topics", Owner::User, "launch/{name}.launch", "package/topics.launch"},
    {"new plugins", Owner::User, "src/{name}-plugin.cpp", "package/plugin.cpp"},
    {"new services", Owner::User, "src/{name}-service.cpp", "package/service.cpp"},
    {"new applications", Owner::User, "src/{name}-application.cpp", "package/application.cpp"},
    {"new supports", Owner::User, "include/{package}/{name}-support.hpp", "package/support.hpp"},
    {"new supports", Owner::User, "src/{name}-support.cpp", "package/support.cpp"}};

Subject aboutClass(const char* kind, const std::string& package, const std::string& name, const model::Text& className,
                   std::function<json()> view) {
    const std::string last = model::lastName(className.value);
    return {kind, {{"package", package}, {"name", name}, {"class", last}}, std::move(view)};
}

/// The subjects that the manifest describes.
std::vector<Subject> describedSubjects(const model::Package& package, const std::string& manifest) {
    const std::string& name = package.name.value;
    std::vector<Subject> all;
    for (const auto& component : package.components)
        all.push_back(aboutClass("component", name, "", component.className,
                                 [&] { return view::componentView(package, component, manifest); }));
    if (!package.components.empty())
        all.push_back({"registration", {{"package", name}}, [&] { return view::registrationView(package, manifest); }});
    all.push_back({"reference", {{"package", name}}, [&] { return view::referenceView(package, manifest); }});
    for (const auto& service : package.services)
        all.push_back(aboutClass("service", name, service.name.value, service.className,
                                 [&] { return view::serviceView(package, service, manifest); }));
    return all;
}

/// The files around the classes.
std::vector<Subject> packageSubjects(const model::Package& package, const std::string& manifest, bool catkin) {
    json view = view::packageView(package, manifest);
    view["buildTool"] = catkin ? "catkin" : "cmake";
    if (catkin) view["isCatkin"] = true;
    std::vector<Subject> all;
    const auto add = [&](bool wanted, const char* kind, const std::string& name, const json& with) {
        if (wanted) all.push_back({kind, {{"package", package.name.value}, {"name", name}}, [with] { return with; }});
    };
    add(true, "package", "", view);
    add(!catkin, "package built alone", "", view);
    add(view["deployable"], "deployment", "", view);
    add(view["hasTests"], "tests", "", view);
    if (!package.typekitHeaders.empty()) {
        const std::string& header = package.typekitHeaders.front().value;
        add(true, "typekit", header, view::typekitView(package, header));
    }
    for (const json& plugin : view["plugins"]) add(true, "plugin", plugin["name"], plugin);
    return all;
}

std::vector<Subject> skeletonSubjects(const model::Package& package) {
    std::vector<Subject> all;
    for (const model::Skeleton& skeleton : package.skeletons)
        all.push_back({"new " + view::listOfKind(skeleton.kind),
                       {{"package", package.name.value}, {"name", skeleton.name}},
                       [&] { return view::skeletonView(package, skeleton); }});
    return all;
}

}  // namespace

emit::Outputs generatedFiles(const model::Package& package, const std::string& manifest,
                             const render::Renderer& renderer) {
    return render::renderOutputs(kOutputs, describedSubjects(package, manifest), Owner::Generated, renderer);
}

std::vector<std::string> generatedFileNames(const model::Package& package) {
    auto names = render::outputNames(kOutputs, describedSubjects(package, ""), Owner::Generated);
    std::sort(names.begin(), names.end());
    return names;
}

std::vector<std::string> classFileNames(const std::string& className, bool isComponent) {
    const Subject subject = aboutClass(isComponent ? "component" : "service", "", "", {className, {}}, nullptr);
    return render::outputNames(kOutputs, {subject}, Owner::User);
}

emit::Outputs skeletonFiles(const model::Package& package, const render::Renderer& renderer) {
    return render::renderOutputs(kOutputs, skeletonSubjects(package), Owner::User, renderer);
}

Scaffold scaffold(const model::Package& package, const std::string& manifest, bool catkin,
                  const render::Renderer& renderer) {
    std::vector<Subject> all = packageSubjects(package, manifest, catkin);
    for (const auto& more : {describedSubjects(package, manifest), skeletonSubjects(package)})
        all.insert(all.end(), more.begin(), more.end());
    return {render::renderOutputs(kOutputs, all, Owner::Shared, renderer),
            render::renderOutputs(kOutputs, all, Owner::User, renderer)};
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
