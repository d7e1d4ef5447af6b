// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/dotted_name.hpp>

#include <rtt/TaskContext.hpp>
#include <rtt/internal/GlobalService.hpp>

#include <algorithm>

namespace RTT::internal {
namespace {

NamedObject objectOf(TaskContext& component, const std::string& name) {
    return {&component, component.provides(), name};
}

/** Follows the parts from `here`. `from` is the component that a path begins in; null for a path through services. */
ResolvedName follow(NamedObject here, const std::vector<std::string>& parts, TaskContext* from) {
    ResolvedName result;
    for (const std::string& part : parts) {
        const bool isFirst = from && result.wrongAt == 0;
        NamedObject next = isFirst ? firstOf(*from, part) : childOf(here, part);
        if (!next.service) {
            result.wrong = part;
            result.known = here.service->getProviderNames();
            if (here.component)
                for (const std::string& peer : here.component->getPeerList()) result.known.push_back(peer);
            return result;
        }
        here = std::move(next);
        result.wrongAt += part.size() + 1;
    }
    result.wrongAt = 0;
    result.target = std::move(here);
    return result;
}

}  // namespace

std::vector<std::string> partsOf(const std::string& path) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin < path.size();) {
        const std::size_t end = std::min(path.find('.', begin), path.size());
        parts.push_back(path.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

std::pair<std::string, std::string> splitAtLastDot(const std::string& path) {
    const std::size_t dot = path.rfind('.');
    if (dot == std::string::npos) return {std::string(), path};
    return {path.substr(0, dot), path.substr(dot + 1)};
}

NamedObject childOf(const NamedObject& here, const std::string& name) {
    if (TaskContext* const peer = here.component ? here.component->getPeer(name) : nullptr)
        return objectOf(*peer, name);
    return {nullptr, here.service->getService(name), name};
}

NamedObject firstOf(TaskContext& component, const std::string& name) {
    const std::string own = component.getName();
    if (name == "this" || name == "task") return objectOf(component, own);
    NamedObject found = childOf(objectOf(component, own), name);
    if (found.service) return found;
    if (name == own) return objectOf(component, own);
    const Service::shared_ptr global = GlobalService::Instance();
    found.service = name == "GlobalService" ? global : global->getService(name);
    return found;
}

ResolvedName resolve(TaskContext& from, const std::string& path) {
    return follow(objectOf(from, from.getName()), partsOf(path), &from);
}

ResolvedName resolve(Service& from, const std::string& path) {
    return follow({nullptr, from.provides(), from.getName()}, partsOf(path), nullptr);
}

base::PortInterface* findPort(Service& service, const std::string& path) {
    return findMember(service, path, [](Service& owner, const std::string& name) { return owner.getPort(name); });
}

}  // namespace RTT::internal
