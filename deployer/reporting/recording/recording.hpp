// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_RECORDING_RECORDING_HPP
#define OROFORGE_RECORDING_RECORDING_HPP

#include "chunk_pipe.hpp"
#include "chunk_takers.hpp"
#include "log_channel.hpp"
#include "recorded_source.hpp"
#include "state_channel.hpp"

#include <reporting/report.hpp>
#include <reporting/running_report.hpp>

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace OCL::recording {

struct RecordingOptions {
    std::string component, file;
    oroforge::mcap::Compression compression = oroforge::mcap::Compression::None;
    std::size_t chunkSize = 0;
    double chunkTime = 0, ring = 0;  ///< seconds; without a ring, everything is written
    std::uint64_t ringSize = 0;      ///< bytes
    Split split;
    bool isReproducible = false;  ///< nothing of this process and its times is recorded
    bool realtime = true;         ///< messages have the time of day; otherwise that of the TimeService
    RecordedSource::Options sources;
    bool hasLog = false;                ///< the lines of the log are recorded
    RTT::TaskContext::PeerGates peers;  ///< those whose states are recorded
    std::function<void()> onFailure;    ///< called once by another thread, when nothing more can be written
};

/** A recording from start() to stop() of its component. */
class Recording final : public reporting::Report {
public:
    /** Null, with an error in the log, if the file cannot be written. */
    static std::unique_ptr<Recording> make(const reporting::Sources& sources, const RecordingOptions& options);
    ~Recording() override;

    /** Adds all samples that are there. Does not wait for the disk; allocates for a sample larger than all before. */
    bool read() override;
    /** While new samples wake the component: the port has some, so read() looks at it. In the thread of read(). */
    void hasData(const RTT::base::PortInterface* port);
    /** Adds properties and attributes that have changed. */
    void writeRow() override;
    void clearPorts() override;
    void wakeOnData(bool on) override;
    void finish() override;
    unsigned long lost() const override;
    bool failed() const override { return file_ && file_->failed(); }

    bool hasRing() const { return last_ != nullptr; }
    /** Writes the ring to a file, and waits for that. */
    bool save() { return last_ && pipe_->save(); }

private:
    explicit Recording(const RecordingOptions& options);
    void add(const std::shared_ptr<reporting::Source>& source);
    std::uint16_t schemaOf(const RTT::encoding::SchemaText& text);
    void addStates();
    void addLog();
    bool begin();
    void mark(std::size_t source);
    bool readSources();
    bool readSource(std::size_t source);
    std::uint64_t now() const;
    oroforge::mcap::Metadata atEnd() const;

    const RecordingOptions options_;
    const std::int64_t toClock_;  // what is added to the time of the TimeService
    FileContent content_;
    std::atomic<std::uint64_t> lostOfSources_{0};
    std::vector<std::unique_ptr<RecordedSource>> sources_;
    std::unordered_map<const RTT::base::PortInterface*, std::size_t> ports_;  // which of the sources
    std::vector<std::size_t> values_;                                         // sources that are no ports
    bool isWoken_ = false;                  // ports with new samples wake the component
    std::vector<std::size_t> withData_;     // then: sources that have some, each once
    std::vector<bool> hasData_;             // which are in there
    std::unique_ptr<StateChannel> states_;  // null: they are not recorded
    std::unique_ptr<LogChannel> log_;       // the same
    std::unique_ptr<FileTaker> file_;       // without a ring
    std::unique_ptr<LastChunks> last_;      // the ring
    std::unique_ptr<ChunkPipe> pipe_;       // last: its thread uses those
    bool everLost_ = false;
};

}  // namespace OCL::recording

#endif
