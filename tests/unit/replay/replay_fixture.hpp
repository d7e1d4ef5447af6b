// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Recordings of our recorder and of others, and ports that read what is replayed.
#ifndef OROFORGE_TESTS_REPLAY_FIXTURE_HPP
#define OROFORGE_TESTS_REPLAY_FIXTURE_HPP

#include <mcap/cdr_bytes.hpp>
#include <mcap/mcap_report_fixture.hpp>
#include <replay/player.hpp>
#include <rtt/InputPort.hpp>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace replay_test {

using mcap_test::Cdr;
using OCL::replay::Player;
using OCL::replay::PlayerOptions;

/** A file as another recorder writes it. */
class OtherFile {
public:
    OtherFile() {
        bytes_.assign(std::begin(oroforge::mcap::kMagic), std::end(oroforge::mcap::kMagic));
        put(bytes_, oroforge::mcap::Header{"ros2", "another recorder"});
    }
    /** The schema of a topic and its metadata. Returns the number of the channel. */
    std::uint16_t topic(const std::string& topic, const std::string& type, const std::string& text,
                        const oroforge::mcap::Texts& metadata = {}, const std::string& language = "ros2msg",
                        const std::string& encoding = "cdr") {
        const auto id = static_cast<std::uint16_t>(++topics_);
        put(bytes_, oroforge::mcap::Schema{id, type, language, text});
        put(bytes_, oroforge::mcap::Channel{id, id, topic, encoding, metadata});
        return id;
    }
    /** A message that is in no chunk. */
    void message(std::uint16_t channel, std::uint64_t time, const std::vector<unsigned char>& data) {
        oroforge::mcap::RecordPut record(bytes_, oroforge::mcap::Op::Message);
        record.number(channel).number(sequence_++).number(time).number(time);
        bytes_.insert(bytes_.end(), data.begin(), data.end());
        record.end();
    }
    void message(std::uint16_t channel, std::uint64_t time, const Cdr& data) { message(channel, time, data.bytes); }
    std::string text() {
        oroforge::mcap::Bytes all = bytes_;
        oroforge::mcap::RecordPut(all, oroforge::mcap::Op::DataEnd).number(std::uint32_t(0)).end();
        oroforge::mcap::RecordPut(all, oroforge::mcap::Op::Footer)
            .number(std::uint64_t(0))
            .number(std::uint64_t(0))
            .number(std::uint32_t(0))
            .end();
        all.insert(all.end(), std::begin(oroforge::mcap::kMagic), std::end(oroforge::mcap::kMagic));
        return {all.begin(), all.end()};
    }

private:
    oroforge::mcap::Bytes bytes_;
    unsigned topics_ = 0;
    std::uint32_t sequence_ = 0;
};

/** An input port that keeps everything. */
template <class T>
struct Reader {
    RTT::InputPort<T> port{"reader"};

    explicit Reader(RTT::base::PortInterface* from) {
        EXPECT_TRUE(from && port.connectTo(from, RTT::ConnPolicy::buffer(10000)));
    }
    std::vector<T> all() {
        std::vector<T> values;
        for (T value; port.read(value) == RTT::NewData;) values.push_back(value);
        return values;
    }
};

class Replay : public mcap_test::Recorder {
protected:
    std::unique_ptr<Player> open(const std::string& name = "run.mcap", bool tolerate = false) {
        std::unique_ptr<Player> player(oroOpenRecording(file(name).c_str(), {tolerate}, error));
        return player;
    }
    RTT::base::OutputPortInterface* port(Player& player, const std::string& topic) {
        RTT::base::OutputPortInterface* const made = player.port(topic, error);
        EXPECT_TRUE(made) << error;
        return made;
    }
    /** Delivers everything; returns the times. */
    static std::vector<RTT::nsecs> play(Player& player) {
        std::vector<RTT::nsecs> times;
        while (const auto next = player.next()) {
            times.push_back(*next);
            player.deliver();
        }
        return times;
    }
    void write(const std::string& name, OtherFile& other) { directory.write(name, other.text()); }

    std::string error;
};

}  // namespace replay_test

#endif
