// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "records.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <system_error>

namespace OCL::deploy {
namespace {

template <class T>
void append(std::vector<T>& list, const std::vector<T>& more) {
    list.insert(list.end(), more.begin(), more.end());
}

/** Adds ports; the same port in the same connection only once, even if several structs name it. */
void appendPorts(std::vector<PortPlan>& ports, const std::vector<PortPlan>& more) {
    for (const PortPlan& port : more) {
        const auto isSame = [&](const PortPlan& known) {
            return known.port.value == port.port.value && known.connection.value == port.connection.value;
        };
        if (std::none_of(ports.begin(), ports.end(), isSame)) ports.push_back(port);
    }
}

bool isSameFile(const std::string& a, const std::string& b) {
    std::error_code none;
    return a == b || std::filesystem::equivalent(a, b, none);
}

/** Adds scripts, but none that came from the same statement, so that a script of a file that is read again runs
    once. */
void appendScripts(std::vector<ScriptPlan>& scripts, const std::vector<ScriptPlan>& more) {
    for (const ScriptPlan& script : more) {
        const auto isSame = [&](const ScriptPlan& known) { return isSameStatement(known, script); };
        if (std::none_of(scripts.begin(), scripts.end(), isSame)) scripts.push_back(script);
    }
}

void replace(Flag& flag, const Flag& newer) {
    if (newer) flag = newer;
}

}  // namespace

bool isSameStatement(const ScriptPlan& a, const ScriptPlan& b) {
    const diag::Location &one = a.file.where, &other = b.file.where;
    return a.file.value == b.file.value && one.line == other.line && one.column == other.column &&
           isSameFile(one.file, other.file);
}

ComponentRecord& ComponentRecords::add(const std::string& name, RTT::TaskContext* instance) {
    erase(instance);  // the record of a destroyed component whose memory this one reuses
    ComponentRecord& record = all.emplace_back();
    record.name = name;
    record.instance = instance;
    places_[instance] = std::prev(all.end());
    return record;
}

void ComponentRecords::erase(const RTT::TaskContext* instance) {
    const auto place = places_.find(instance);
    if (place == places_.end()) return;
    all.erase(place->second);
    places_.erase(place);
}

ComponentRecord* ComponentRecords::find(const std::string& name) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const ComponentRecord& record) { return record.name == name; });
    return found == all.end() ? nullptr : &*found;
}

ComponentRecord* ComponentRecords::find(const RTT::TaskContext* instance) {
    const auto place = places_.find(instance);
    return place == places_.end() ? nullptr : &*place->second;
}

void ComponentRecords::merge(ComponentPlan& known, const ComponentPlan& more) {
    known.name = more.name;
    if (known.type.empty() || more.type.value != "PropertyBag") known.type = more.type;
    replace(known.autoConf, more.autoConf);
    replace(known.autoStart, more.autoStart);
    replace(known.autoConnect, more.autoConnect);
    replace(known.autoSave, more.autoSave);
    append(known.services, more.services);
    append(known.properties, more.properties);
    append(known.propertyFiles, more.propertyFiles);
    appendPorts(known.ports, more.ports);
    append(known.peers, more.peers);
    append(known.members, more.members);
    appendScripts(known.scripts, more.scripts);
    if (more.activity) known.activity = more.activity;
}

std::vector<Connection> ComponentRecords::connections() const {
    std::vector<Connection> result;
    std::map<std::string, std::size_t> index;
    for (const ComponentRecord& record : all)
        for (const PortPlan& port : record.plan.ports) {
            const std::string& name = port.connection.value;
            const auto known = index.emplace(name, result.size());
            if (known.second) {
                const auto policy = policies.find(name);
                result.push_back(
                    Connection{name, policy == policies.end() ? RTT::ConnPolicy() : policy->second.policy, {}});
            }
            result[known.first->second].members.push_back(Connection::Member{&record, &port});
        }
    // Where transports connect several ports, each pair gets a name of its own.
    for (Connection& one : result)
        if (one.policy.name_id.empty() && (one.policy.transport == 0 || one.members.size() == 1))
            one.policy.name_id = one.name;
    return result;
}

}  // namespace OCL::deploy
