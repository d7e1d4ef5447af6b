// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_RECORDING_RECORD_FILE_HPP
#define OROFORGE_RECORDING_RECORD_FILE_HPP

#include "chunk_pipe.hpp"

#include <reporting/mcap/compression.hpp>
#include <reporting/mcap/writer.hpp>

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace OCL::recording {

/** What all files of a recording have in common. */
struct FileContent {
    std::string file;  ///< the name of the first one
    oroforge::mcap::Header header;
    std::vector<oroforge::mcap::Schema> schemas;
    std::vector<oroforge::mcap::Channel> channels;
    std::vector<oroforge::mcap::Metadata> about;
    std::function<oroforge::mcap::Metadata()> atEnd;  ///< what is known when a file ends
    oroforge::mcap::Compression compression = oroforge::mcap::Compression::None;
};

/** "run.mcap", "run_1.mcap", "run_2.mcap" … */
std::string numberedName(const std::string& file, unsigned number);

/** One file from its beginning to its end. Logs the first failure, after which nothing more is written. */
class RecordFile {
public:
    /** Begins the file anew. It has failed if it cannot be opened, or another recorder writes to it. */
    RecordFile(const FileContent& content, const std::string& file);
    /** Leaves the file without its end. */
    ~RecordFile();

    bool write(const oroforge::mcap::PackedChunk& chunk);
    bool finish();
    bool failed() const { return !error_.empty(); }
    /** What is wrong, with the file. */
    const std::string& error() const { return error_; }
    std::uint64_t size() const { return writer_.offset(); }

private:
    class FileSink;
    bool note(bool good);

    const FileContent& content_;
    const std::string file_;
    std::string error_;  // in front of what sets it
    const std::unique_ptr<FileSink> sink_;
    oroforge::mcap::Writer writer_;
};

/** When a file ends and the next one begins; 0: never. */
struct Split {
    std::uint64_t bytes = 0, nanoseconds = 0;
};

/** Writes each chunk at once. */
class FileTaker : public ChunkTaker {
public:
    FileTaker(const FileContent& content, const Split& split);
    /** Why the first file could not be begun; empty if all is well. */
    const std::string& error() const { return file_->error(); }

    bool take(const oroforge::mcap::Chunk& chunk) override;
    /** Ends the file. Called when the thread of the pipe has ended. */
    void finish();
    bool failed() const { return failed_.load(std::memory_order_relaxed); }

private:
    bool isFull(const oroforge::mcap::PackedChunk& next) const;

    const FileContent& content_;
    const Split split_;
    std::unique_ptr<oroforge::mcap::Compressor> compressor_;
    oroforge::mcap::PackedChunk packed_;
    std::unique_ptr<RecordFile> file_;
    unsigned number_ = 0;       // of the file
    std::uint64_t begin_ = 0;   // the time of its first message
    bool hasMessages_ = false;  // in the file
    std::atomic<bool> failed_{false};
};

/** Keeps the last seconds in memory, compressed, and writes them to a file when save() is called: a flight recorder. */
class LastChunks : public ChunkTaker {
public:
    /** @param bytes what the chunks may take together; the oldest are forgotten for that. */
    LastChunks(const FileContent& content, double seconds, std::uint64_t bytes);

    bool take(const oroforge::mcap::Chunk& chunk) override;
    bool save() override;

private:
    const FileContent& content_;
    typedef std::unique_ptr<oroforge::mcap::PackedChunk> Packed;
    Packed takeOldest();
    static std::uint64_t memoryOf(const oroforge::mcap::PackedChunk& chunk);

    const std::uint64_t span_, most_;
    std::unique_ptr<oroforge::mcap::Compressor> compressor_;
    std::deque<Packed> chunks_;
    std::uint64_t size_ = 0;  // of the memory of all of them
    bool isShort_ = false;    // the log says that there is no room for all seconds
    unsigned number_ = 0;
};

}  // namespace OCL::recording

#endif
