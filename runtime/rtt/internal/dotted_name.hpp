// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Resolves names such as "tank.gauge.level", by one set of rules for consoles, the deployer and reports:
//
// 1. A part leads from a component to one of its peers, else to one of its services; from a service only to a service.
// 2. The first part may also be "this" or "task", which come before everything else; after everything else the own name
//    of the component, "GlobalService", and the services of the process.
// 3. The name of a port or value at the end may itself have dots, in files and reports. The longest name that exists is
//    meant.
#ifndef ORO_INTERNAL_DOTTED_NAME_HPP
#define ORO_INTERNAL_DOTTED_NAME_HPP

#include <rtt/Service.hpp>

#include <string>
#include <utility>
#include <vector>

namespace RTT {
class TaskContext;

namespace internal {

/** A component or service that a name leads to. */
struct NamedObject {
    TaskContext* component = nullptr;  ///< null for a service
    Service::shared_ptr service;       ///< the main one of a component; null if nothing was found
    std::string name;                  ///< the last part of the path
};

struct ResolvedName {
    NamedObject target;
    // If the path leads nowhere: its first unknown part, where that begins, and the names that may replace it.
    std::string wrong;
    std::size_t wrongAt = 0;
    std::vector<std::string> known;
};

/** The parts of "a.b.c"; a dot at the end begins no part. */
RTT_API std::vector<std::string> partsOf(const std::string& path);
/** What comes before the last dot, and what comes after it: the path of the owner, perhaps empty, and the last name. */
RTT_API std::pair<std::string, std::string> splitAtLastDot(const std::string& path);

/** The peer or service of that name, by rule 1. */
RTT_API NamedObject childOf(const NamedObject& here, const std::string& name);
/** The object that the first part of a path means in a component, by rules 1 and 2. */
RTT_API NamedObject firstOf(TaskContext& component, const std::string& name);

/** Follows a path from a component; an empty one leads to it. */
RTT_API ResolvedName resolve(TaskContext& from, const std::string& path);
/** Follows a path through services only. */
RTT_API ResolvedName resolve(Service& from, const std::string& path);

/** The port or value at the path through services, by rule 3: the first result of `find(Service&, name)`
    that is not null. */
template <class Find>
auto findMember(Service& service, const std::string& path, Find find) -> decltype(find(service, path)) {
    Service::shared_ptr inner;
    std::string name = path;
    for (Service* at = &service;; at = inner.get()) {
        if (const auto found = find(*at, name)) return found;
        const std::size_t dot = name.find('.');
        inner = dot == std::string::npos ? nullptr : at->getService(name.substr(0, dot));
        if (!inner) return nullptr;
        name.erase(0, dot + 1);
    }
}

/** The port at the path; null if there is none. */
RTT_API base::PortInterface* findPort(Service& service, const std::string& path);

}  // namespace internal
}  // namespace RTT

#endif
