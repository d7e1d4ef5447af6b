// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "chains.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/Property.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/deployment/ComponentLoader.hpp>

namespace OCL::deploy {
namespace {

typedef RTT::Property<std::vector<std::string>> OrderProperty;

constexpr const char* kOthers = "*";

OrderProperty* orderOf(RTT::TaskContext& component) {
    return dynamic_cast<OrderProperty*>(component.getProperty("sched_order"));
}

std::string noChain(const std::string& name) {
    return "component '" + name + "' is no chain: it has no property sched_order; a component of type " + kChainType +
           " is one";
}

bool addMember(Session& session, RTT::TaskContext& chain, const std::string& name, std::string& error) {
    RTT::TaskContext* const member = session.component(name);
    if (!member) {
        error = "there is no component '" + name + "'";
        return false;
    }
    if (changeActivity(session, *member, ActivityKind::Slave, {}, &chain, error)) return true;
    error = "component '" + name + "' cannot be a member: " + error;
    return false;
}

void setMembersOf(Session& session, ComponentRecord& record, diag::Sink& sink) {
    OrderProperty* const order = orderOf(*record.instance);
    if (!order) {
        sink.error(record.plan.members.front().where, "DEP054", noChain(record.name));
        return;
    }
    std::vector<std::string> names;
    for (const Text& member : record.plan.members) {
        std::string error;
        names.push_back(member.value);
        if (member.value == kOthers || addMember(session, *record.instance, member.value, error)) continue;
        sink.error(member.where, "DEP054", "chain '" + record.name + "': " + error);
    }
    order->set(names);
}

RTT::TaskContext* createChain(Session& session, const std::string& name, std::string& error) {
    const auto loader = RTT::ComponentLoader::Instance();
    if (!loader->isImported(kChainType) && !loader->import("ocl", std::string(), error)) return nullptr;
    return create(session, name, kChainType, 0, error);
}

bool setUp(Session& session, RTT::TaskContext& chain, const ActivityNumbers& numbers,
           const std::vector<std::string>& members, std::string& error) {
    OrderProperty* const order = orderOf(chain);
    if (!order) {
        error = noChain(chain.getName());
        return false;
    }
    if (!changeActivity(session, chain, ActivityKind::Activity, numbers, nullptr, error)) return false;
    for (const std::string& member : members)
        if (member != kOthers && !addMember(session, chain, member, error)) return false;
    order->set(members);
    return true;
}

/** What a chain says of itself; empty if the component is none. */
std::string descriptionOf(RTT::TaskContext& component) {
    if (!orderOf(component) || !component.provides()->hasOperation("describe")) return {};
    RTT::OperationCaller<std::string()> describe = component.provides()->getOperation("describe");
    return describe.ready() ? describe() : std::string();
}

}  // namespace

void setMembers(Session& session, const std::vector<ComponentRecord*>& records, diag::Sink& sink) {
    for (ComponentRecord* const record : records)
        if (!record->plan.members.empty()) setMembersOf(session, *record, sink);
}

bool makeChain(Session& session, const std::string& name, const ActivityNumbers& numbers,
               const std::vector<std::string>& members, std::string& error) {
    RTT::TaskContext* const known = session.component(name);
    RTT::TaskContext* const chain = known ? known : createChain(session, name, error);
    if (!chain) return false;
    if (setUp(session, *chain, numbers, members, error)) return true;
    if (!known) (void)unloadOne(session, *chain);
    return false;
}

std::string chainsOf(const Session& session) {
    std::string text;
    for (const ComponentRecord& record : session.records.all)
        // One that a checked script made has no slaves, because the script does not run.
        if (!record.isRemote && (!session.startsNothing || record.group != 0)) text += descriptionOf(*record.instance);
    return text + plannedChainsOf(session);
}

}  // namespace OCL::deploy
