// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_FOXGLOVE_GRAPH_HPP
#define OROFORGE_LIVE_FOXGLOVE_GRAPH_HPP

#include "foxglove_model.hpp"

#include <nlohmann/json.hpp>

#include <map>
#include <set>
#include <string>

namespace OCL::live {

/** Which component writes and reads which topic, as a client of Foxglove knows it. Without services: the deployer has
    some seventy, which would hide the topics. */
class FoxgloveGraph {
public:
    /** The message that tells the client about what has changed; null if nothing has. `connections` as in the answer
        to oro.graph. */
    nlohmann::json update(const FoxgloveModel& model, const nlohmann::json& connections);
    /** The client knows nothing. */
    void forget() { *this = {}; }

private:
    typedef std::map<std::string, std::set<std::string>> Components;  // by topic
    Components writers_, readers_;
};

}  // namespace OCL::live

#endif
