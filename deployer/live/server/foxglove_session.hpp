// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_FOXGLOVE_SESSION_HPP
#define OROFORGE_LIVE_FOXGLOVE_SESSION_HPP

#include "../samples/log_lines.hpp"
#include "../samples/port_watch.hpp"
#include "foxglove_graph.hpp"
#include "foxglove_model.hpp"
#include "foxglove_text.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace OCL::live {

class LiveClient;

/** A client that speaks Foxglove's WebSocket protocol, version 1. */
class FoxgloveSession {
public:
    explicit FoxgloveSession(LiveClient& client);

    /** Messages that are wrong, or ask for what is not offered, are answered by a status. */
    void receive(const nlohmann::json& message, const std::string& op);
    void receiveBinary(std::string_view message);
    /** At `now`, ns of the monotonic clock. */
    void onTick(std::int64_t now);
    void onLines(const std::vector<LogLine>& lines);
    bool wantsLines() const { return !logs_.empty(); }
    /** In ms. */
    unsigned wantedPeriod() const;

private:
    struct Subscription {
        std::string path;
        std::unique_ptr<PortWatch> port;  // null while the port is not there
    };
    typedef std::map<std::string, nlohmann::json> Parameters;  // by name
    typedef std::function<void(const Parameters&)> Use;
    void subscribe(const nlohmann::json& message);
    void unsubscribe(const nlohmann::json& message);
    void watch(Subscription& subscription, bool again = false);
    void getParameters(const nlohmann::json& message);
    void setParameters(const nlohmann::json& message);
    struct Collection;
    void collectAll(Use use);
    void collect(const std::shared_ptr<Collection>& collection);
    void updateParameters();
    void updateGraph();
    void fail(const FoxgloveCall& call, const std::string& why);
    struct Sample {
        std::int64_t time;  // ns since 1970
        std::uint32_t subscription;
        std::string value;
    };
    void sendSamples(std::int64_t now);
    void readAll(std::uint32_t id, Subscription& subscription, std::vector<Sample>& samples);
    void sendTime(std::int64_t time, std::int64_t now);
    void warn(const std::string& text);

    LiveClient& client_;
    FoxgloveModel model_;
    std::map<std::uint32_t, Subscription> subscriptions_;
    std::set<std::uint32_t> logs_;  // subscriptions of the log
    std::set<std::string> followed_;
    Parameters lastValues_;  // of those
    bool wantsGraph_ = false, isUpdating_ = false;
    FoxgloveGraph graph_;
    std::vector<Use> waiting_;  // for parameters, until the model knows its components
    std::int64_t nextPoll_ = 0, nextTime_ = 0;
    std::int64_t lastTime_ = 0;  // that the client knows, ns since 1970
};

}  // namespace OCL::live

#endif
