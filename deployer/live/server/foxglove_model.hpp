// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_FOXGLOVE_MODEL_HPP
#define OROFORGE_LIVE_FOXGLOVE_MODEL_HPP

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace OCL::live {

class LiveClient;

/** What of a deployment a client of Foxglove's protocol knows: ports as channels, operations as services. */
class FoxgloveModel {
public:
    struct Channel {
        std::uint32_t id = 0;
        std::string path;  ///< "Arm.pose"
    };
    struct Service {
        std::uint32_t id = 0;
        std::string path;
        std::vector<std::string> arguments;
    };
    explicit FoxgloveModel(LiveClient& client) : client_(client) {}

    /** Asks what there is, and tells the client what has changed since the last time. */
    void poll();
    /** False until all that there was at the first poll() has been shown. */
    bool isKnown() const { return hasTree_ && underWay_ == 0; }
    const Channel* channel(std::uint32_t id) const;
    const Service* service(std::uint32_t id) const;
    /** The components and services with properties. */
    std::vector<std::string> owners() const;
    /** The paths of the ports that are channels. */
    std::vector<std::string> outputs() const;

private:
    struct Owner {
        std::vector<Channel> channels;
        std::vector<Service> services;
        bool hasProperties = false;
    };
    void onTree(const nlohmann::json& components);
    void addPaths(const nlohmann::json& node, const std::string& path, std::set<std::string>& paths);
    void onShown(const std::string& path, const nlohmann::json& shown);
    void addChannels(Owner& owner, const std::string& path, const nlohmann::json& ports);
    void addServices(Owner& owner, const std::string& path, const nlohmann::json& operations);
    void remove(const Owner& owner);

    LiveClient& client_;
    std::map<std::string, std::string> nodes_;  // what the tree says of each component, without its state
    std::map<std::string, Owner> owners_;       // by path
    std::set<std::string> refused_;             // ports that have no form, and whose client knows that
    bool hasTree_ = false;
    std::size_t underWay_ = 0;  // questions
    std::uint32_t lastId_ = 1;  // 1 is the log
};

/** "/Arm/pose" */
std::string topicOf(std::string path);

}  // namespace OCL::live

#endif
