// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "lookup.hpp"

#include "failure.hpp"

#include <diag/nearest_match.hpp>
#include <rtt/ExecutionEngine.hpp>
#include <rtt/internal/GlobalService.hpp>
#include <rtt/internal/dotted_name.hpp>

#include <algorithm>
#include <utility>

namespace OCL::live {
namespace {

using RTT::TaskContext;

constexpr std::size_t kLongestPath = 4096;

/** "a.b[2].c" as its parts; brackets must hold digits. */
std::vector<std::string> partsOf(const std::string& path) {
    if (path.size() > kLongestPath) throw Failure(kMalformed, "a path of more than 4096 letters");
    std::string dotted;
    for (std::size_t at = 0; at < path.size(); ++at) {
        if (path[at] != '[') {
            dotted += path[at];
            continue;
        }
        const std::size_t close = path.find(']', at);
        const std::string index = close == std::string::npos ? "" : path.substr(at + 1, close - at - 1);
        if (index.empty() || index.find_first_not_of("0123456789") != std::string::npos)
            throw Failure(kMalformed,
                          "path '" + path + "': expected an index such as [2] at letter " + std::to_string(at + 1));
        dotted += "." + index;
        at = close;
    }
    std::vector<std::string> parts = RTT::internal::partsOf(dotted);
    if (std::count(parts.begin(), parts.end(), std::string()) != 0)
        throw Failure(kMalformed, "path '" + path + "' has an empty part");
    return parts;
}

Gate peerOf(const TaskContext& component, const std::string& name) {
    for (const auto& [peer, gate] : component.getPeerGates())
        if (peer == name) return gate;
    return nullptr;
}

std::vector<std::string> namesIn(const Found& at) {
    RTT::Service& service = *at.service;
    std::vector<std::string> names = service.getProviderNames();
    const auto add = [&](const std::vector<std::string>& more) { names.insert(names.end(), more.begin(), more.end()); };
    if (at.isComponent)
        for (const auto& [peer, gate] : at.component->getPeerGates()) names.push_back(peer);
    add(service.properties()->list());
    add(service.getAttributeNames());
    add(service.getNames());
    add(service.getPortNames());
    return names;
}

bool hasMember(RTT::Service& service, const std::string& name) {
    return service.getProperty(name) || service.getValue(name) || service.hasMember(name) || service.getPort(name);
}

void enterComponent(Found& at, Visits& visits, const Gate& gate, const std::string& name) {
    TaskContext* const component = visits.enter(gate);
    if (!component) throw Failure(kGone, "component '" + name + "' was destroyed");
    at.component = component;
    at.gate = gate;
    at.service = component->provides();
    at.isComponent = true;
}

/** Goes on to the peer or service of that name; false if there is none. */
bool step(Found& at, Visits& visits, const Root& root, const std::string& part, bool first) {
    const auto named = [&] { at.path = at.path.empty() ? part : at.path + "." + part; };
    if (first && (part == "this" || part == "task")) return true;
    if (at.isComponent) {
        if (const Gate gate = peerOf(*at.component, part)) return enterComponent(at, visits, gate, part), named(), true;
    }
    // A property or port of the same name as a service is what people ask for; a port has a service, too.
    if (hasMember(*at.service, part)) return false;
    RTT::Service::shared_ptr service = at.service->getService(part);
    if (!service && first && part == root.name) return true;
    if (!service && first) {
        const RTT::Service::shared_ptr global = RTT::internal::GlobalService::Instance();
        service = part == "GlobalService" ? global : global->getService(part);
        if (service) at.component = nullptr, at.gate = nullptr;
    }
    if (!service) return false;
    at.service = std::move(service);
    at.isComponent = false;
    return named(), true;
}

/** The longest name of a member that the parts begin with, as one part: names may have dots. */
std::vector<std::string> joined(RTT::Service& service, std::vector<std::string> parts) {
    constexpr std::size_t kMostParts = 16;  // of one name
    for (std::size_t count = std::min(parts.size(), kMostParts); count > 1; --count) {
        std::string name = parts[0];
        for (std::size_t i = 1; i != count; ++i) name += "." + parts[i];
        if (!hasMember(service, name)) continue;
        parts.erase(parts.begin() + 1, parts.begin() + static_cast<std::ptrdiff_t>(count));
        parts[0] = std::move(name);
        break;
    }
    return parts;
}

}  // namespace

Found find(const Root& root, Visits& visits, const std::string& path) {
    const std::vector<std::string> parts = partsOf(path);
    Found at;
    enterComponent(at, visits, root.gate, root.name);
    std::size_t next = 0;
    for (;; ++next) {
        at.rest = joined(*at.service, {parts.begin() + static_cast<std::ptrdiff_t>(next), parts.end()});
        const bool isMember = !at.rest.empty() && at.rest.size() < parts.size() - next;
        if (at.rest.empty() || isMember || !step(at, visits, root, parts[next], next == 0)) break;
    }
    if (!at.rest.empty()) at.known = namesIn(at);
    return at;
}

Found findComponent(const Root& root, Visits& visits, const std::string& path) {
    Found found = find(root, visits, path);
    if (!found.rest.empty()) unknown(found, "component");
    if (!found.isComponent) throw Failure(kUnknownName, "'" + path + "' is a service, expected a component");
    return found;
}

void unknown(const Found& found, const char* what) {
    const std::string& name = found.rest.front();
    const std::string in = found.path.empty() ? found.componentName() : found.path;
    if (std::find(found.known.begin(), found.known.end(), name) != found.known.end())
        throw Failure(kUnknownName, "'" + in + "." + name + "' is no " + what);
    throw Failure(kUnknownName, std::string("there is no ") + what + " '" + name + "' in '" + in + "'" +
                                    oroforge::diag::didYouMean(name, found.known));
}

}  // namespace OCL::live
