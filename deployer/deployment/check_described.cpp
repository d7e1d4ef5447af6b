// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "check_described.hpp"

#include "described_values.hpp"
#include "missing_typekits.hpp"
#include "port_faults.hpp"
#include "read_value.hpp"
#include "xml_to_plan.hpp"

#include <diag/nearest_match.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/TypeInfoRepository.hpp>

#include <boost/core/demangle.hpp>

#include <algorithm>
#include <cstring>

namespace OCL::deploy {
namespace {

using RTT::internal::ComponentDescription;
using RTT::internal::DescribedList;
using RTT::internal::DescribedPort;

/** A component, of this plan or an earlier one, that its library describes. */
struct Described {
    const ComponentDescription* description;
    const Text* type;       // the type in the struct that creates it
    bool hasMore = false;   // has other ports and properties: the manifest says so, or services add them
    bool hasLater = false;  // has other ports, which scripts may add
};

struct Member {
    const Text* where;
    std::string name;           // component.port
    const DescribedPort* port;  // null if it is not described
    bool isOfPlan;              // false for an earlier plan, whose errors were reported
};

struct DescribedConnection {
    std::string name;
    std::vector<Member> members;
};

template <class Entry>
const Entry* findIn(const DescribedList<Entry>& list, const std::string& name) {
    const auto found = std::find_if(list.begin(), list.end(), [&](const Entry& one) { return name == one.name; });
    return found == list.end() ? nullptr : found;
}

template <class Entry>
std::vector<std::string> namesOf(const DescribedList<Entry>& list) {
    std::vector<std::string> names;
    for (const Entry& one : list) names.emplace_back(one.name);
    return names;
}

/** As RTT::internal::sampleTypeName() names the type of a port. */
std::string typeName(const std::type_info& type) {
    const RTT::types::TypeInfo* known = RTT::types::TypeInfoRepository::Instance()->getTypeById(&type);
    return known ? known->getTypeName() : boost::core::demangle(type.name()) + " (of no loaded typekit)";
}

/** Adds notes: where the description comes from, and what to do if it is incomplete. */
template <class Entry>
void explain(diag::Diagnostic& error, const Described& component, const DescribedList<Entry>& list, const char* what) {
    std::string names;
    std::size_t shown = 0;
    for (const Entry& one : list) {
        if (++shown > 10) break;
        names += (names.empty() ? ": '" : ", '") + std::string(one.name) + "'";
    }
    if (list.count > 10) names += " and " + std::to_string(list.count - 10) + " more";
    error.note(component.type->where, "the manifest of package '" + std::string(component.description->package) +
                                          "' lists " + (list.count ? "the " : "no ") + what + names);
    error.hint(std::string("if the class adds ") + what +
               " by itself, say dynamic=\"true\" for the component in that manifest");
}

class DescribedCheck {
public:
    DescribedCheck(const Plan& plan, const PlanContext& around, diag::Sink& sink)
        : plan_(plan), around_(around), sink_(sink) {
        for (const Plan* earlier : around.planned) findComponents(*earlier);
        findComponents(plan);
    }

    void run() {
        if (components_.empty()) return;
        for (const Plan* earlier : around_.planned) findConnections(*earlier, /*isOfPlan=*/false);
        findConnections(plan_, /*isOfPlan=*/true);
        if (around_.planOnly) checkNames();
        for (const DescribedConnection& connection : connections_) {
            checkTypes(connection);
            if (around_.planOnly) checkDirections(connection);
        }
    }

private:
    void findComponents(const Plan& plan) {
        for (const ComponentPlan& component : plan.components) {
            const auto known = around_.descriptions.find(component.type.value);
            if (known != around_.descriptions.end() && !exists(component, around_))
                components_.emplace(component.name.value,
                                    Described{known->second, &component.type, known->second->dynamic});
        }
        for (const ComponentPlan& component : plan.components) {
            const auto known = components_.find(component.name.value);
            if (known == components_.end()) continue;
            known->second.hasMore |= !component.services.empty();
            known->second.hasLater |= !component.scripts.empty();
        }
    }

    const Described* find(const ComponentPlan& component) const {
        const auto known = components_.find(component.name.value);
        return known == components_.end() ? nullptr : &known->second;
    }

    void findConnections(const Plan& plan, bool isOfPlan) {
        for (const ComponentPlan& component : plan.components)
            for (const PortPlan& port : component.ports) {
                const std::string& name = port.connection.value;
                const auto known = index_.emplace(name, connections_.size());
                if (known.second) connections_.push_back(DescribedConnection{name, {}});
                addMember(connections_[known.first->second].members, component, port.port, isOfPlan);
            }
    }

    /** Several structs of a component may name the same port. */
    void addMember(std::vector<Member>& members, const ComponentPlan& component, const Text& port, bool isOfPlan) {
        const std::string name = component.name.value + "." + port.value;
        if (std::any_of(members.begin(), members.end(), [&](const Member& one) { return one.name == name; })) return;
        const Described* owner = find(component);
        members.push_back(
            Member{&port, name, owner ? findIn(owner->description->ports, port.value) : nullptr, isOfPlan});
    }

    void checkNames() {
        MissingTypekits typekits(plan_, sink_);
        for (const ComponentPlan& component : plan_.components)
            if (const Described* described = find(component)) {
                typekits.check(component, *described->description);
                if (!described->hasMore && !described->hasLater) checkPortNames(component, *described);
                if (!described->hasMore) checkPropertyNames(component, *described);
                checkDescribedValues(component, *described->description, *around_.propertyFiles, sink_);
                for (const PropertyFilePlan& file : component.propertyFiles)
                    if (file.mode == PropertyFilePlan::Strict) checkStrictFile(component, *described, file.file);
            }
    }

    void checkPortNames(const ComponentPlan& component, const Described& described) {
        const auto& ports = described.description->ports;
        for (const PortPlan& port : component.ports)
            if (!findIn(ports, port.port.value))
                explain(reportUnknownPort(component.name.value, port.port, namesOf(ports), sink_), described, ports,
                        "ports");
    }

    void checkPropertyNames(const ComponentPlan& component, const Described& described) {
        const auto& known = described.description->properties;
        for (const xml::Element& properties : component.properties)
            for (const xml::Element& property : properties.children) {
                const Text name = nameOf(property);
                if (property.name == "description" || name.empty() || findIn(known, name.value)) continue;
                explain(sink_.error(name.where, "DEP043",
                                    "component '" + component.name.value + "' has no property '" + name.value + "'" +
                                        diag::didYouMean(name.value, namesOf(known))),
                        described, known, "properties");
            }
    }

    /** A strict property file must have all properties of the component. It may have others. */
    void checkStrictFile(const ComponentPlan& component, const Described& described, const Text& file) {
        const auto* read = around_.propertyFiles->readAgain(resolveFile(file));
        if (!read) return;
        const std::vector<std::string> inFile = read->bag.list();
        for (const auto& property : described.description->properties) {
            const std::string name = property.name;
            if (name.find('.') != std::string::npos || read->bag.find(name)) continue;
            sink_
                .error(file.where, "DEP052",
                       "could not set the properties of component '" + component.name.value + "' from '" + file.value +
                           "': property '" + name + "' of type '" + typeName(*property.type) + "' is missing" +
                           diag::didYouMean(name, inFile))
                .note(described.type->where,
                      "the manifest of package '" + std::string(described.description->package) + "' has the property");
        }
    }

    void checkTypes(const DescribedConnection& connection) {
        const Member* first = nullptr;
        for (const Member& member : connection.members) {
            if (!member.port) continue;
            if (!first) first = &member;
            if (!member.isOfPlan || std::strcmp(member.port->type->name(), first->port->type->name()) == 0) continue;
            reportOtherType(connection.name, shown(*first), shown(member), sink_);
        }
    }

    static ConnectedPort shown(const Member& member) {
        return {member.where->where, member.name, typeName(*member.port->type), member.port->output};
    }

    /** Only for a plan that is not applied. Otherwise checkComponents() does it, because a later plan may add ports. */
    void checkDirections(const DescribedConnection& connection) {
        const std::vector<Member>& members = connection.members;
        const auto isUnknown = [](const Member& one) { return !one.port; };
        if (members.size() < 2 || !members[1].isOfPlan || around_.connections.count(connection.name) ||
            std::any_of(members.begin(), members.end(), isUnknown))
            return;
        std::vector<ConnectedPort> ports;
        // Without types, because looking up their names is slow.
        for (const Member& one : members) ports.push_back({one.where->where, one.name, "", one.port->output});
        deploy::checkDirections(connection.name, ports, sink_);
    }

    const Plan& plan_;
    const PlanContext& around_;
    diag::Sink& sink_;
    std::map<std::string, Described> components_;  // by name
    std::vector<DescribedConnection> connections_;
    std::map<std::string, std::size_t> index_;  // of connections_, by name
};

}  // namespace

void checkDescribed(const Plan& plan, const PlanContext& context, diag::Sink& sink) {
    DescribedCheck(plan, context, sink).run();
}

}  // namespace OCL::deploy
