// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <view/skeleton_view.hpp>

#include <algorithm>
#include <cctype>

#include <model/names.hpp>
#include <view/cpp_text.hpp>
#include <view/interface_view.hpp>

namespace oroforge::view {

namespace {

using model::SkeletonKind;
using nlohmann::json;

const model::Skeleton* firstComponent(const model::Package& package) {
    const auto& all = package.skeletons;
    const auto found =
        std::find_if(all.begin(), all.end(), [](const auto& one) { return one.kind == SkeletonKind::Component; });
    return found == all.end() ? nullptr : &*found;
}

}  // namespace

std::string listOfKind(SkeletonKind kind) {
    switch (kind) {
        case SkeletonKind::Component: return "components";
        case SkeletonKind::Topics: return "topics";
        case SkeletonKind::Plugin: return "plugins";
        case SkeletonKind::Service: return "services";
        case SkeletonKind::Support: return "supports";
        case SkeletonKind::Application: return "applications";
    }
    return "";
}

std::string instanceName(const std::string& className) {
    std::string result = className;
    if (!result.empty()) result[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(result[0])));
    return result;
}

json skeletonView(const model::Package& package, const model::Skeleton& skeleton) {
    const std::string space = model::namespaceOf(skeleton.className);
    const model::Skeleton* component = firstComponent(package);
    json view;
    view["package"] = package.name.value;
    view["name"] = skeleton.name;
    view["class"] = model::lastName(skeleton.className);
    view["qualified"] = skeleton.className;
    view["namespace"] = orNull(space);
    // Functions of a library need a namespace, so that one process can load two packages.
    view["space"] = space.empty() ? identifier(package.name.value) : space;
    view["guard"] = guardName(skeleton.name);
    view["instance"] = instanceName(model::lastName(skeleton.className));
    view["service"] = identifier(skeleton.name) + "_service";
    view["plugin"] = skeleton.name + "-plugin";
    view["node"] = identifier(skeleton.name);
    view["target"] = skeleton.kind == SkeletonKind::Topics ? skeleton.name + "-topics" : skeleton.name;
    view["source"] = skeleton.name + (skeleton.kind == SkeletonKind::Topics ? "-topics" : "-component");
    view["comment"] = nullptr;
    view["withComponent"] = orNull(component == nullptr ? "" : component->name);
    if (skeleton.kind == SkeletonKind::Application && component != nullptr) {
        view["instance"] = instanceName(model::lastName(component->className));
    }
    view["componentClass"] = component == nullptr ? model::lastName(skeleton.className) : component->className;
    return view;
}

json skeletonsView(const model::Package& package) {
    json view;
    for (const char* list : {"components", "topics", "plugins", "services", "supports", "applications"}) {
        view[list] = json::array();
    }
    std::string headers;
    for (const model::Skeleton& skeleton : package.skeletons) {
        view[listOfKind(skeleton.kind)].push_back(skeletonView(package, skeleton));
        if (skeleton.kind == SkeletonKind::Component) headers += " src/" + skeleton.name + "-component.hpp";
        if (skeleton.kind == SkeletonKind::Support) {
            headers += " include/" + package.name.value + "/" + skeleton.name + "-support.hpp";
        }
    }
    view["headerList"] = orNull(headers.empty() ? "" : headers.substr(1));
    view["tested"] = view["components"];
    for (const json& topics : view["topics"]) view["tested"].push_back(topics);
    view["hasTests"] = !view["tested"].empty();
    return view;
}

}  // namespace oroforge::view
