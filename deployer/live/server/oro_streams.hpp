// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_ORO_STREAMS_HPP
#define OROFORGE_LIVE_ORO_STREAMS_HPP

#include "../samples/log_lines.hpp"
#include "../samples/port_watch.hpp"
#include "sample_batch.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace OCL::live {

class LiveClient;

/** How often watched ports are read, in ms. */
constexpr unsigned kWatchPeriod = 10;

/** The verbs watch, unwatch, log and unlog of one client. */
class OroStreams {
public:
    explicit OroStreams(LiveClient& client) : client_(client) {}

    /** False if the verb is another one. */
    bool receive(const nlohmann::json& message, const nlohmann::json& id, const std::string& op);
    /** Reads the ports, at `now`, ns of the monotonic clock. */
    void onTick(std::int64_t now);
    /** `dropped`: lines that were lost before these, since the beginning. */
    void onLines(const std::vector<LogLine>& lines, std::uint64_t dropped);
    bool hasWatches() const { return !watches_.empty(); }
    bool wantsLines() const { return !logs_.empty(); }

private:
    struct Watch {
        nlohmann::json id;
        std::string path;
        std::unique_ptr<PortWatch> port;
        std::uint64_t channel = 0;
        std::int64_t period = 0;                 // ns; 0: every sample
        std::int64_t next = 0;                   // when it may be read again
        std::unique_ptr<SampleBatches> batches;  // null: samples are JSON
    };
    struct Log {
        nlohmann::json id;
        RTT::LoggerLevel level = RTT::Info;
        std::uint64_t channel = 0;
        std::uint64_t before = 0;  // lines that were lost before it began
    };
    void watch(const nlohmann::json& message, const nlohmann::json& id);
    void log(const nlohmann::json& message, const nlohmann::json& id);
    void end(const nlohmann::json& message, const nlohmann::json& id, const char* field);
    void endWatch(Watch& watch, const nlohmann::json& message, const nlohmann::json& id);
    bool readAll(Watch& watch, std::int64_t now);

    LiveClient& client_;
    std::map<std::string, Watch> watches_;  // by the text of their ids
    std::map<std::string, Log> logs_;
    std::uint64_t lastChannel_ = std::uint64_t(1) << 32U;  // those below are subscriptions of Foxglove
    std::uint64_t lostLines_ = 0;
};

}  // namespace OCL::live

#endif
