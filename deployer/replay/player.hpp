// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What repeats a recording. It is in the component library `replay`, with the library of MCAP files. A deployer loads
// it when it is needed.
#ifndef OROFORGE_REPLAY_PLAYER_HPP
#define OROFORGE_REPLAY_PLAYER_HPP

#include <rtt/Time.hpp>
#include <rtt/base/OutputPortInterface.hpp>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace OCL::replay {

/** Something that happens at given times of a replay. Used by one thread at a time. */
class TimedSource {
public:
    virtual ~TimedSource() = default;
    /** When the next delivery is due: the time of a message, in ns as os::TimeService counts. Never earlier than the
        one before. None at the end. */
    virtual std::optional<RTT::nsecs> next() = 0;
    /** Delivers everything that is due at next(), in the order of the file. */
    virtual void deliver() = 0;
};

/** A port as it was recorded. */
struct Topic {
    std::string topic;        ///< "/Camera/image"
    std::string component;    ///< "Camera"; empty if the topic has no such part
    std::string port;         ///< "image", or "service.port"
    std::string type;         ///< the name in C++, or that of the schema if the file has no other
    unsigned long count = 0;  ///< of its messages; 0 if it is unknown
};

/**
 * Repeats the ports of a recording. Properties, attributes and states in it are left out.
 *
 * Memory is needed for an index with a line for each chunk, and for the chunks that overlap in time. A file without
 * its index is read once from its beginning when it is opened.
 */
class Player : public TimedSource {
public:
    /** The ports that the file has, in the order of the file. */
    virtual const std::vector<Topic>& topics() const = 0;
    /** The output port that repeats the topic, made at the first call, and owned by the player. It has no component.
        Null, with an explanation, if its type is not loaded or is not the recorded one. `problem` may be set with a
        port, too: with `tolerate`, it says which fields are not repeated. Messages of topics without a port are
        skipped. */
    virtual RTT::base::OutputPortInterface* port(const std::string& topic, std::string& problem) = 0;
    /** What was left out so far because it is damaged or does not fit its type, with a text for each place or kind:
        "run.mcap: byte 4711: error: [MCP003] …". */
    virtual std::vector<std::string> problems() const = 0;
    /** The record `oroforge` of the file, which the recorder writes: `clock`, `command` … Empty if there is none. */
    virtual const std::map<std::string, std::string>& metadata() const = 0;
    /** The times of the first and the last message in the file, of any topic. */
    virtual RTT::nsecs begin() const = 0;
    virtual RTT::nsecs end() const = 0;
    /** Samples written since the file was opened. */
    virtual std::uint64_t written() const = 0;
};

struct PlayerOptions {
    /** A recorded type may differ from the loaded one: fields that are not recorded keep their defaults. */
    bool tolerate = false;
};

}  // namespace OCL::replay

/** Opens a recording. Null, with an error, if it cannot be read at all. Throws nothing; allocates. */
extern "C" OCL::replay::Player* oroOpenRecording(const char* file, const OCL::replay::PlayerOptions& options,
                                                 std::string& error) noexcept;

#endif
