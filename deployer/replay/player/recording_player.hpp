// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_REPLAY_RECORDING_PLAYER_HPP
#define OROFORGE_REPLAY_RECORDING_PLAYER_HPP

#include "../player.hpp"
#include "problem_list.hpp"
#include "repeated_port.hpp"

#include <reporting/mcap/contents.hpp>
#include <reporting/mcap/in_order.hpp>
#include <reporting/mcap/source.hpp>

#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace OCL::replay {

/** The player of a file. */
class RecordingPlayer final : public Player {
public:
    /** Null, with an error, if the file cannot be read at all. */
    static std::unique_ptr<RecordingPlayer> open(const std::string& file, const PlayerOptions& options,
                                                 std::string& error);
    ~RecordingPlayer() override;

    const std::vector<Topic>& topics() const override { return topics_; }
    RTT::base::OutputPortInterface* port(const std::string& topic, std::string& problem) override;
    std::vector<std::string> problems() const override { return problems_.all(); }
    const std::map<std::string, std::string>& metadata() const override { return metadata_; }
    std::optional<RTT::nsecs> next() override;
    void deliver() override;

    RTT::nsecs begin() const override { return begin_; }
    RTT::nsecs end() const override { return end_; }
    std::uint64_t written() const override { return written_; }
    /** Goes on with the messages from this time on; those at `to` and later are left out. */
    void seek(RTT::nsecs from, RTT::nsecs to = std::numeric_limits<RTT::nsecs>::max());
    /** Messages left out since the file was opened. */
    std::uint64_t leftOut() const { return leftOut_; }
    std::size_t problemCount() const { return problems_.size(); }

private:
    /** The channels of one topic write to one port. */
    struct Channel {
        std::size_t topic = 0;
        std::unique_ptr<MessageDecoder> decoder;  // null: its messages are left out
    };
    RecordingPlayer(std::string file, const PlayerOptions& options, std::unique_ptr<oroforge::mcap::Source> source);
    void learn();
    void addTopic(std::uint16_t id, const oroforge::mcap::Channel& channel);
    const oroforge::mcap::Schema* schemaOf(const oroforge::mcap::Channel& channel) const;
    bool connect(std::uint16_t id, RepeatedPort& port, std::string& problem);
    std::string located(const Refusal& refusal, const std::string& topic) const;
    void begin(std::uint64_t from);
    void advance();
    void write(const oroforge::mcap::Message& message);

    const std::string file_;
    const PlayerOptions options_;
    const std::unique_ptr<oroforge::mcap::Source> source_;
    ProblemList problems_;
    oroforge::mcap::Contents contents_;
    std::map<std::string, std::string> metadata_;
    std::vector<Topic> topics_;
    std::vector<std::unique_ptr<RepeatedPort>> ports_;  // of each topic; null until it is asked for
    std::map<std::uint16_t, Channel> channels_;
    RTT::nsecs begin_ = 0, end_ = 0;
    std::uint64_t from_ = 0, to_ = std::numeric_limits<RTT::nsecs>::max();

    std::unique_ptr<oroforge::mcap::InOrder> messages_;  // null until the first one is asked for
    const oroforge::mcap::Message* ahead_ = nullptr;     // the next one; null at the end
    RTT::nsecs due_ = 0;                                 // its time, but not earlier than that of the one before
    std::optional<RTT::nsecs> delivered_;                // since seek()
    std::uint64_t written_ = 0, leftOut_ = 0;
};

}  // namespace OCL::replay

#endif
