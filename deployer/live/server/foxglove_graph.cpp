// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "foxglove_graph.hpp"

#include "../samples/port_watch.hpp"

#include <utility>

namespace OCL::live {
namespace {

using nlohmann::json;

std::string componentOf(const std::string& path) { return path.substr(0, path.find('.')); }

/** Those of `now` that `before` lacks or has otherwise. */
template <class Components>
json changed(const Components& before, const Components& now, const char* ids) {
    json all = json::array();
    for (const auto& [name, components] : now) {
        const auto known = before.find(name);
        if (known == before.end() || known->second != components) all.push_back({{"name", name}, {ids, components}});
    }
    return all;
}

template <class Components>
json gone(const Components& before, const Components& now) {
    json all = json::array();
    for (const auto& known : before)
        if (now.count(known.first) == 0) all.push_back(known.first);
    return all;
}

}  // namespace

json FoxgloveGraph::update(const FoxgloveModel& model, const json& connections) {
    FoxgloveGraph now;
    for (const std::string& path : model.outputs()) {
        now.writers_[topicOf(path)].insert(componentOf(path));
        now.readers_[topicOf(path)];  // a topic that loses its last reader changes, too
    }
    for (const json& one : connections) {
        const std::string from = one.value("from", ""), to = one.value("to", ""), topic = topicOf(from);
        if (to == PortWatch::kName) continue;  // a client, perhaps this one
        now.writers_[topic].insert(componentOf(from));
        now.readers_[topic].insert(componentOf(to));
    }
    json made = {{"op", "connectionGraphUpdate"},
                 {"publishedTopics", changed(writers_, now.writers_, "publisherIds")},
                 {"subscribedTopics", changed(readers_, now.readers_, "subscriberIds")},
                 {"advertisedServices", json::array()},
                 {"removedTopics", gone(writers_, now.writers_)},
                 {"removedServices", json::array()}};
    *this = std::move(now);
    for (const json& part : made)
        if (part.is_array() && !part.empty()) return made;
    return nullptr;
}

}  // namespace OCL::live
