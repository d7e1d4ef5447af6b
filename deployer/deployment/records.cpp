// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "records.hpp"

#include <algorithm>

namespace OCL::deploy {
namespace {

template <class T>
void append(std::vector<T>& list, const std::vector<T>& more) {
    list.insert(list.end(), more.begin(), more.end());
}

void replace(Flag& flag, const Flag& newer) {
    if (newer) flag = newer;
}

}  // namespace

Record* Records::find(const std::string& name) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Record& record) { return record.name == name; });
    return found == all.end() ? nullptr : &*found;
}

Record* Records::find(const RTT::TaskContext* instance) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Record& record) { return record.instance == instance; });
    return found == all.end() ? nullptr : &*found;
}

bool Records::has(const Record* record) const {
    return std::any_of(all.begin(), all.end(), [&](const Record& known) { return &known == record; });
}

void Records::merge(ComponentPlan& known, const ComponentPlan& more) {
    known.name = more.name;
    known.type = more.type;
    replace(known.autoConf, more.autoConf);
    replace(known.autoStart, more.autoStart);
    replace(known.autoConnect, more.autoConnect);
    replace(known.autoSave, more.autoSave);
    append(known.services, more.services);
    append(known.properties, more.properties);
    append(known.propertyFiles, more.propertyFiles);
    append(known.ports, more.ports);
    append(known.peers, more.peers);
    append(known.scripts, more.scripts);
    if (more.activity) known.activity = more.activity;
}

std::vector<Connection> Records::connections() const {
    std::vector<Connection> result;
    std::map<std::string, std::size_t> index;
    for (const Record& record : all)
        for (const PortPlan& port : record.plan.ports) {
            const std::string& name = port.connection.value;
            const auto known = index.emplace(name, result.size());
            if (known.second) {
                const auto policy = policies.find(name);
                result.push_back(
                    Connection{name, policy == policies.end() ? RTT::ConnPolicy() : policy->second.policy, {}});
                if (result.back().policy.name_id.empty()) result.back().policy.name_id = name;
            }
            result[known.first->second].members.push_back(Connection::Member{&record, &port});
        }
    return result;
}

void Records::erase(const RTT::TaskContext* instance) {
    all.remove_if([&](const Record& record) { return record.instance == instance; });
}

}  // namespace OCL::deploy
