// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The verbs `tree` and `show`.
#include "failure.hpp"
#include "fields.hpp"
#include "found_value.hpp"
#include "interface_json.hpp"
#include "permissions.hpp"
#include "verbs.hpp"

#include <console/scripted.hpp>
#include <rtt/Attribute.hpp>
#include <rtt/base/PropertyBase.hpp>
#include <rtt/internal/flow/connection_facts.hpp>
#include <rtt/os/fosi.h>

#include <set>
#include <utility>

namespace OCL::live {
namespace {

using nlohmann::json;

constexpr unsigned kDeepest = 16;
constexpr std::size_t kMostText = 64 * 1024;
constexpr const char* kUsualDoc = "The interface of this TaskContext.";

std::string docOf(RTT::Service& service) { return service.doc() == kUsualDoc ? "" : service.doc(); }

json countsOf(RTT::Service& service) {
    return {{"properties", service.properties()->size()},
            {"attributes", service.getValues().size()},
            {"operations", service.getNames().size()},
            {"ports", service.getPorts().size()}};
}

json servicesOf(RTT::Service& service, unsigned depth) {
    json all = json::array();
    if (depth > kDeepest) return all;
    for (const std::string& name : service.getProviderNames()) {
        const auto inner = name == "this" || service.getPort(name) ? nullptr : service.getService(name);
        if (inner) all.push_back({{"name", name}, {"doc", inner->doc()}, {"services", servicesOf(*inner, depth + 1)}});
    }
    return all;
}

json nodeOf(const std::string& name, RTT::TaskContext& component) {
    return {{"name", name},
            {"type", classOf(component)},
            {"state", stateOf(component)},
            {"services", servicesOf(*component.provides(), 0)},
            {"counts", countsOf(*component.provides())}};
}

json peersOf(RTT::TaskContext& component) {
    json all = json::array();
    for (const auto& [name, gate] : component.getPeerGates()) {
        Visits visits;
        RTT::TaskContext* const peer = visits.enter(gate);
        if (peer) all.push_back({{"name", name}, {"state", stateOf(*peer)}});
    }
    return all;
}

json scriptedOf(RTT::TaskContext& component, bool machines) {
    json all = json::array();
    for (const auto& each : OCL::console::scriptedIn(component, machines))
        all.push_back({{"name", each.name}, {"status", each.status}, {"state", each.state}});
    return all;
}

json requiredOf(RTT::TaskContext& component) {
    json all = json::array();
    const auto add = [&](const RTT::ServiceRequester& requester, const std::string& prefix) {
        for (const std::string& name : requester.getOperationCallerNames()) {
            const auto* const caller = requester.getOperationCaller(name);
            all.push_back({{"name", prefix + name}, {"connected", caller && caller->ready()}});
        }
    };
    const auto required = component.requires_();
    add(*required, "");
    for (const std::string& name : required->getRequesterNames()) add(*required->requires_(name), name + ".");
    return all;
}

/** What is shown, and the copies of the values that belong to the entries of its lists. */
struct Shown {
    json made;
    Gate gate;
    std::string component;
    std::vector<std::shared_ptr<Copied>> properties, attributes;
};

json operationIn(const Asked& asked, const Found& at, const RTT::OperationInterfacePart& part) {
    Found named = at;
    named.rest = {part.getName()};
    json made = operationJson(part);
    made["allowed"] = asked.caller.rights.operations && whyNotCalled(asked, named).empty();
    return made;
}

void addInterface(Shown& to, const Asked& asked, const Found& at, const KnownPorts& known) {
    RTT::Service& service = *at.service;
    json properties = json::array(), attributes = json::array(), operations = json::array(), ports = json::array();
    for (const auto* const property : *service.properties()) {
        properties.push_back(propertyHead(*property));
        to.properties.push_back(std::make_shared<Copied>(property->getDataSource()));
    }
    for (const auto* const attribute : service.getValues()) {
        attributes.push_back(attributeHead(*attribute));
        to.attributes.push_back(std::make_shared<Copied>(attribute->getDataSource()));
    }
    for (const std::string& name : service.getNames())
        if (const auto* const part = service.getPart(name)) operations.push_back(operationIn(asked, at, *part));
    std::size_t left = kMostText / 2;
    for (const auto* const port : service.getPorts()) {
        ports.push_back(portJson(*port, known, std::min<std::size_t>(left, 1024)));
        left -= std::min(left, ports.back()["text"].get_ref<const std::string&>().size());
    }
    to.made["properties"] = std::move(properties);
    to.made["attributes"] = std::move(attributes);
    to.made["operations"] = std::move(operations);
    to.made["ports"] = std::move(ports);
    to.made["services"] = servicesOf(service, 0);
}

/** The values, from the thread of the component; without them, and with the reason, if that does not answer. */
void addValues(Shown& to, const Limit& limit) {
    std::vector<std::shared_ptr<Copied>> all = to.properties;
    all.insert(all.end(), to.attributes.begin(), to.attributes.end());
    try {
        // In time to answer without them.
        const std::int64_t now = rtos_get_time_ns();
        fill(to.gate, to.component, {now + (limit.deadline - now) * 3 / 4, limit.seconds}, all);
    } catch (const Failure& failure) {
        to.made["missing"] = failure.what();
        return;
    }
    std::size_t left = kMostText;
    const auto add = [&](const char* list, const std::vector<std::shared_ptr<Copied>>& copies) {
        for (std::size_t i = 0; i != copies.size(); ++i) addValue(to.made[list][i], copies[i]->value(), left);
    };
    add("properties", to.properties);
    add("attributes", to.attributes);
}

json showMember(const Asked& asked, const Found& at, const KnownPorts& known) {
    const std::string& name = at.rest.front();
    RTT::Service& service = *at.service;
    json made;
    if (const auto* const port = service.getPort(name)) {
        made = portJson(*port, known, kMostText);
        made["kind"] = "port";
        json policies = json::array();
        for (const auto& connection : port->getManager()->getConnections())
            policies.push_back(
                {{"port", known.partnerOf(connection)}, {"policy", RTT::internal::policyText(connection.get<2>())}});
        made["connections"] = std::move(policies);
    } else if (const auto* const part = service.getPart(name)) {
        made = operationIn(asked, at, *part);
        made["kind"] = "operation";
    } else {
        unknown(at, "property, attribute, operation, port, service or component");
    }
    made["path"] = at.pathWith(name);
    return made;
}

bool isValue(const Found& at) {
    if (at.rest.empty()) return false;
    const std::string& name = at.rest.front();
    if (at.service->getProperty(name) || at.service->getValue(name)) return true;
    return at.rest.size() > 1 && at.service->getPort(name);  // a field of a sample
}

}  // namespace

json tree(const Asked& asked) {
    const std::string path = textField(asked.request, "path", "");
    Visits visits;
    const Found at = findComponent(asked.root, visits, path);
    json components = json::array();
    components.push_back(nodeOf(at.path.empty() ? at.componentName() : at.path, *at.component));
    std::set<const RTT::TaskContext*> seen{at.component};
    for (const auto& [name, gate] : at.component->getPeerGates()) {
        Visits inner;
        RTT::TaskContext* const peer = inner.enter(gate);
        if (peer && seen.insert(peer).second) components.push_back(nodeOf(at.pathWith(name), *peer));
    }
    return {{"components", std::move(components)}};
}

json show(const Asked& asked) {
    const std::string path = textField(asked.request, "path", "");
    Shown shown;
    {
        Visits visits;
        const Found at = find(asked.root, visits, path);
        if (!isValue(at)) {
            const KnownPorts known({asked.root.gate}, visits);
            if (!at.rest.empty()) return showMember(asked, at, known);
            shown.gate = at.gate;
            shown.component = at.componentName();
            shown.made = {{"path", at.path},
                          {"name", at.isComponent ? at.componentName() : at.service->getName()},
                          {"kind", at.isComponent ? "component" : "service"},
                          {"doc", docOf(*at.service)}};
            if (at.isComponent) {
                shown.made["type"] = classOf(*at.component);
                shown.made["state"] = stateOf(*at.component);
                shown.made["peers"] = peersOf(*at.component);
                shown.made["required"] = requiredOf(*at.component);
                shown.made["programs"] = scriptedOf(*at.component, false);
                shown.made["machines"] = scriptedOf(*at.component, true);
            }
            addInterface(shown, asked, at, known);
        }
    }
    if (shown.made.is_null()) {
        const FoundValue found = findValue(asked, path);
        return described(found, read(found, asked.limit));
    }
    addValues(shown, asked.limit);
    return std::move(shown.made);
}

}  // namespace OCL::live
