// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_RECORDING_RECORDED_SOURCE_HPP
#define OROFORGE_RECORDING_RECORDED_SOURCE_HPP

#include "chunk_pipe.hpp"

#include <reporting/mcap/records.hpp>
#include <reporting/source.hpp>
#include <rtt/base/ChannelElementBase.hpp>
#include <rtt/encoding/Plan.hpp>
#include <rtt/encoding/SchemaText.hpp>
#include <rtt/encoding/Stamp.hpp>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace OCL::recording {

/** A port or value whose samples become messages of a channel. Used by one thread at a time, but for lost(). */
class RecordedSource {
public:
    struct Options {
        RTT::encoding::SchemaLanguage language = RTT::encoding::SchemaLanguage::Auto;
        bool rosNames = false;
    };
    /** Null, with the reason, if its type cannot be encoded or described. What it loses is added to `allLost`. */
    static std::unique_ptr<RecordedSource> make(std::shared_ptr<reporting::Source> source, const Options& options,
                                                std::atomic<std::uint64_t>& allLost, std::string& why);

    const reporting::Source& source() const { return *source_; }
    const RTT::encoding::SchemaText& schema() const { return schema_; }
    /** What describes the messages in a file; its schema is not set. */
    oroforge::mcap::Channel channel(std::uint16_t id);

    /** Adds all new samples of a port, at most `most`. True if there were any. */
    bool addSamples(ChunkPipe& pipe, const std::function<std::uint64_t()>& now, unsigned most);
    /** Adds a value that is no port, if it is not what it was. */
    void addValue(ChunkPipe& pipe, std::uint64_t now);
    void forgetSamples();
    RTT::base::InputPortInterface* port() const { return source_->port(); }

    /** Samples that the connection dropped, for which there was no room, or that could not be encoded. */
    std::uint64_t lost() const { return lost_.load(std::memory_order_relaxed); }

private:
    RecordedSource(std::shared_ptr<reporting::Source> source, std::shared_ptr<const RTT::encoding::Plan> plan,
                   RTT::encoding::SchemaText schema, std::atomic<std::uint64_t>& allLost);
    void add(ChunkPipe::Filling& filling, std::uint64_t now);
    void lose(std::uint64_t count);
    /** Looks for what counts dropped samples: the port may be connected anew at any time. */
    void findStores();
    void countDropped();
    std::size_t dropped() const;

    const std::shared_ptr<reporting::Source> source_;
    const std::shared_ptr<const RTT::encoding::Plan> plan_;
    const RTT::encoding::SchemaText schema_;
    const void* const sample_;
    std::unique_ptr<const RTT::encoding::Stamp> stamp_;  // null: its values have no time
    std::uint16_t id_ = 0;
    std::uint32_t sequence_ = 0;
    std::vector<RTT::base::ChannelElementBase::shared_ptr> stores_;
    std::uint64_t connectionChanges_ = 0;  // when those were found
    std::size_t dropped_ = 0;
    std::atomic<std::uint64_t> lost_{0};
    std::atomic<std::uint64_t>& allLost_;
    std::vector<unsigned char> last_, now_;  // of a value
    bool isUnencodable_ = false;
};

}  // namespace OCL::recording

#endif
