// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <view/view.hpp>

#include <emit/banner.hpp>
#include <model/doc_text.hpp>
#include <model/literal.hpp>
#include <model/names.hpp>
#include <view/cpp_text.hpp>
#include <view/interface_view.hpp>

namespace oroforge::view {

namespace {

using nlohmann::json;

const char* const kTool = "orocreate-pkg";

json activityView(const model::Activity& activity) {
    // As in RTT::Activity's constructors, a priority above 0 implies the scheduler that has priorities.
    const char* usual = activity.priority && activity.priority->value > 0 ? "ORO_SCHED_RT" : "ORO_SCHED_OTHER";
    const std::string scheduler = activity.scheduler.given() ? activity.scheduler.value : usual;
    const std::string priority = activity.priority ? activity.priority->text : "RTT::os::LowestPriority";
    const std::string period = model::valueLiteral(activity.period ? activity.period->text : "0", "double");
    switch (activity.kind) {
        case model::ActivityKind::Sequential:
            return {{"header", "rtt/extras/SequentialActivity.hpp"}, {"make", "RTT::extras::SequentialActivity()"}};
        case model::ActivityKind::Slave:
            return {{"header", "rtt/extras/SlaveActivity.hpp"}, {"make", "RTT::extras::SlaveActivity(" + period + ")"}};
        case model::ActivityKind::Periodic:
        case model::ActivityKind::NonPeriodic: break;
    }
    return {{"header", "rtt/Activity.hpp"},
            {"make", "RTT::Activity(" + scheduler + ", " + priority + ", " + period + ", nullptr, name)"}};
}

template <class Items, class MakeView>
json listOf(const Items& items, MakeView makeView) {
    json list = json::array();
    for (const auto& item : items) list.push_back(makeView(item));
    return list;
}

json hooksOf(const model::Hooks& hooks) {
    json view;
    for (const model::Hook& hook : model::kHooks) view[hook.name] = hooks.*hook.wanted;
    return view;
}

/// Keys that the classes of components and of services have in common.
json classView(const model::Package& package, const model::Text& className, const std::string& doc,
               const std::string& manifest) {
    const std::string qualified = className.value;
    json view;
    view["banner"] = emit::banner(kTool, manifest);
    view["versionGuard"] = emit::versionGuard(kTool);
    view["package"] = package.name.value;
    view["manifest"] = manifest;
    view["class"] = model::lastName(qualified);
    view["qualified"] = qualified;
    view["namespace"] = orNull(model::namespaceOf(qualified));
    view["guard"] = guardName(package.name.value + "_" + model::lastName(qualified));
    view["doc"] = model::commentLines(doc);
    view["headers"] = listOf(package.typekitHeaders,
                             [&](const auto& header) { return includeName(header.value, package.name.value); });
    view["hasHeaders"] = !package.typekitHeaders.empty();
    return view;
}

/// The registration of a component, and the constants that describe it.
json describedView(const model::Component& component) {
    const std::string qualified = component.className.value;
    const std::string space = model::namespaceOf(qualified);
    const std::string holder = (space.empty() ? "" : space + "::") + "OroDescriptionOf" + model::lastName(qualified);
    json view{{"class", model::lastName(qualified)}, {"qualified", qualified}, {"namespace", orNull(space)}};
    putInterface(view, component);
    view["described"] = view["has_ports"] || view["has_properties"];
    view["portTable"] = view["has_ports"] ? holder + "::oroPorts" : "{}";
    view["propertyTable"] = view["has_properties"] ? holder + "::oroProperties" : "{}";
    view["dynamic"] = component.dynamic ? "true" : "false";
    return view;
}

json headersFor(std::vector<std::string> types) {
    types.push_back("std::string");
    return standardHeaders(types);
}

}  // namespace

json componentView(const model::Package& package, const model::Component& component, const std::string& manifest) {
    json view = classView(package, component.className, component.doc, manifest);
    view["stdHeaders"] = headersFor(typesIn(component, component.required));
    view["initial"] = component.initial == model::InitialState::Stopped ? "Stopped" : "PreOperational";
    view["activity"] = component.activity ? activityView(*component.activity) : json(nullptr);
    const bool periodic = component.activity && component.activity->period;
    view["period"] = periodic ? json(model::valueLiteral(component.activity->period->text, "double")) : json(nullptr);
    putInterface(view, component);
    view["required"] = requirementViews(component.required);
    view["callers"] = json::array();
    for (const json& service : view["required"]) {
        for (const json& caller : service["callers"]) view["callers"].push_back(caller);
    }
    view["has_callers"] = !view["callers"].empty();
    view["hasMembers"] = view["hasMembers"] || view["has_callers"];
    view["hooks"] = hooksOf(component.hooks);
    for (const json& wanted : view["hooks"]) view["hasHooks"] = view.value("hasHooks", false) || wanted.get<bool>();
    return view;
}

json serviceView(const model::Package& package, const model::ServicePlugin& service, const std::string& manifest) {
    json view = classView(package, service.className, service.doc, manifest);
    view["stdHeaders"] = headersFor(typesIn(service, {}));
    view["service"] = service.name.value;
    view["serviceDoc"] = service.doc.empty() ? json(nullptr) : json(model::stringLiteral(model::oneLine(service.doc)));
    putInterface(view, service);
    return view;
}

json registrationView(const model::Package& package, const std::string& manifest) {
    json view;
    view["banner"] = emit::banner(kTool, manifest);
    view["versionGuard"] = emit::versionGuard(kTool);
    view["package"] = package.name.value;
    view["components"] = listOf(package.components, describedView);
    view["single"] = package.components.size() == 1;
    return view;
}

}  // namespace oroforge::view
