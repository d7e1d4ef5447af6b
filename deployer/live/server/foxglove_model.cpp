// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "foxglove_model.hpp"

#include "foxglove_service.hpp"
#include "foxglove_text.hpp"
#include "live_client.hpp"
#include "oro_messages.hpp"

#include <algorithm>

namespace OCL::live {

using nlohmann::json;

std::string topicOf(std::string path) {
    std::replace(path.begin(), path.end(), '.', '/');
    return "/" + path;
}

void FoxgloveModel::poll() {
    client_.ask({{"op", "oro.tree"}, {"id", 0}}, [this](LiveClient&, const json& answer) {
        if (answer.count("result") != 0) onTree(answer["result"].value("components", json::array()));
    });
}

void FoxgloveModel::addPaths(const json& node, const std::string& path, std::set<std::string>& paths) {
    paths.insert(path);
    for (const json& service : node.value("services", json::array()))
        addPaths(service, path + "." + service.value("name", ""), paths);
}

void FoxgloveModel::onTree(const json& components) {
    hasTree_ = true;
    std::set<std::string> present;
    for (json node : components) {
        const std::string name = node.value("name", "");
        std::set<std::string> paths;
        addPaths(node, name, paths);
        present.insert(paths.begin(), paths.end());
        node.erase("state");
        const std::string text = textOf(node);
        std::string& known = nodes_[name];
        if (known == text) continue;
        known = text;
        underWay_ += paths.size();
        for (const std::string& path : paths)
            client_.ask({{"op", "oro.show"}, {"id", 0}, {"path", path}}, [this, path](LiveClient&, const json& answer) {
                --underWay_;
                if (answer.count("result") != 0) onShown(path, answer["result"]);
            });
    }
    for (auto at = owners_.begin(); at != owners_.end();) {
        if (present.count(at->first) != 0) {
            ++at;
            continue;
        }
        remove(at->second);
        nodes_.erase(at->first);
        at = owners_.erase(at);
    }
}

void FoxgloveModel::onShown(const std::string& path, const json& shown) {
    Owner& owner = owners_[path];
    remove(owner);
    owner = {};
    owner.hasProperties = !shown.value("properties", json::array()).empty();
    addChannels(owner, path, shown.value("ports", json::array()));
    addServices(owner, path, shown.value("operations", json::array()));
}

void FoxgloveModel::addChannels(Owner& owner, const std::string& path, const json& ports) {
    json channels = json::array();
    for (const json& port : ports) {
        if (port.value("direction", "") != "out") continue;
        const std::string full = path + "." + port.value("name", "");
        json described;
        std::string why;
        if (client_.host().describe(full, described, why)) {
            described["id"] = ++lastId_;
            described["topic"] = topicOf(full);
            channels.push_back(std::move(described));
            owner.channels.push_back({lastId_, full});
        } else if (refused_.insert(full).second) {
            client_.sendText(foxgloveStatus(0, "port '" + full + "' is no channel: " + why));
        }
    }
    if (!channels.empty()) client_.sendText(textOf({{"op", "advertise"}, {"channels", channels}}));
}

void FoxgloveModel::addServices(Owner& owner, const std::string& path, const json& operations) {
    json services = json::array();
    for (const json& operation : operations) {
        if (operation.value("usual", false) || !operation.value("allowed", false)) continue;
        Service made;
        made.id = ++lastId_;
        made.path = path + "." + operation.value("name", "");
        for (const json& argument : operation.value("arguments", json::array()))
            made.arguments.push_back(argument.value("name", ""));
        services.push_back(foxgloveService(made.id, topicOf(made.path), made.path, operation));
        owner.services.push_back(std::move(made));
    }
    if (!services.empty()) client_.sendText(textOf({{"op", "advertiseServices"}, {"services", services}}));
}

void FoxgloveModel::remove(const Owner& owner) {
    json channels = json::array(), services = json::array();
    for (const Channel& channel : owner.channels) channels.push_back(channel.id);
    for (const Service& service : owner.services) services.push_back(service.id);
    if (!channels.empty()) client_.sendText(textOf({{"op", "unadvertise"}, {"channelIds", channels}}));
    if (!services.empty()) client_.sendText(textOf({{"op", "unadvertiseServices"}, {"serviceIds", services}}));
}

const FoxgloveModel::Channel* FoxgloveModel::channel(std::uint32_t id) const {
    for (const auto& [path, owner] : owners_)
        for (const Channel& channel : owner.channels)
            if (channel.id == id) return &channel;
    return nullptr;
}

const FoxgloveModel::Service* FoxgloveModel::service(std::uint32_t id) const {
    for (const auto& [path, owner] : owners_)
        for (const Service& service : owner.services)
            if (service.id == id) return &service;
    return nullptr;
}

std::vector<std::string> FoxgloveModel::owners() const {
    std::vector<std::string> paths;
    for (const auto& [path, owner] : owners_)
        if (owner.hasProperties) paths.push_back(path);
    return paths;
}

std::vector<std::string> FoxgloveModel::outputs() const {
    std::vector<std::string> paths;
    for (const auto& [name, owner] : owners_)
        for (const Channel& channel : owner.channels) paths.push_back(channel.path);
    return paths;
}

}  // namespace OCL::live
