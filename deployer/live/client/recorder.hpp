// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_CLIENT_RECORDER_HPP
#define OROFORGE_LIVE_CLIENT_RECORDER_HPP

#include "connection.hpp"
#include "json.hpp"

#include <reporting/mcap/chunk.hpp>
#include <reporting/mcap_file/record_file.hpp>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace oroforge::live_client {

/**
 * Writes samples of ports to a recording, in the form of OCL::McapReporting. Samples that did not come are gaps in the
 * sequence numbers of their topic, and are counted. Functions throw a Failure if the file cannot be written.
 */
class Recorder {
public:
    struct Options {
        std::string file;
        OCL::recording::Split split;
        mcap::Compression compression = mcap::Compression::None;
        bool keepsOthers = true;  ///< files of a split that exist already are left alone
    };
    /** Begins the file. */
    Recorder(const Options& options, mcap::Texts about);
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    /** Samples of that port come from now on, as `answer`, that of oro.watch, describes them. False, with the reason,
        if a file has no room for another topic. */
    bool addPort(const std::string& port, const Json& answer, std::string& why);
    /** A binary message of the deployment. */
    void addSamples(std::string_view message);
    /** The samples of that stream have ended; the next one would have had that number. */
    void endStream(std::uint32_t stream, std::uint64_t next);
    void addLine(const Json& line);

    /** Writes messages that have waited long enough for others. */
    void writeDue();
    /** When a message that waits, or comes now, shall be written. */
    Deadline due() const;
    void finish();

    std::uint64_t messages() const { return messages_; }
    std::uint64_t lost() const;
    std::uint64_t bytes() const { return files_->size(); }
    unsigned files() const { return files_->files(); }
    /** Ports with at least one message. */
    std::size_t topics() const;

private:
    struct Topic {
        std::uint16_t channel = 0;
        std::uint32_t sequence = 0;
        std::uint64_t messages = 0, lost = 0;
    };
    struct Stream {
        Topic* topic;
        std::uint64_t next;  // number of its next sample
    };
    std::uint16_t schemaOf(const std::string& name, const std::string& encoding, const std::string& text);
    Topic* topicFor(mcap::Channel channel);
    void skipTo(Stream& stream, std::uint64_t number);
    void add(Topic& topic, std::uint64_t time, const unsigned char* data, std::size_t size);
    void writeChunk();
    void check(bool good) const;
    mcap::Metadata atEnd() const;

    OCL::recording::FileContent content_;
    std::map<std::uint16_t, Topic> topics_;  // by channel
    std::map<std::uint32_t, Stream> streams_;
    mcap::Chunk chunk_;
    Deadline chunkSince_;
    std::uint64_t messages_ = 0;
    std::uint64_t lostLines_ = 0;
    Topic* log_ = nullptr;
    std::unique_ptr<OCL::recording::FileSequence> files_;
};

}  // namespace oroforge::live_client

#endif
