// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_RECORDING_RECORD_FILE_HPP
#define OROFORGE_RECORDING_RECORD_FILE_HPP

#include "split.hpp"

#include <reporting/mcap/chunk.hpp>
#include <reporting/mcap/compression.hpp>
#include <reporting/mcap/writer.hpp>

#include <atomic>
#include <cstdint>
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

/** One file from its beginning to its end. After the first failure nothing more is written. */
class RecordFile {
public:
    /** Begins the file anew. It has failed if it cannot be opened, or another recorder writes to it. */
    RecordFile(const FileContent& content, const std::string& file);
    /** Leaves the file without its end. */
    ~RecordFile();

    /** Adds what the content has since the file was begun. */
    bool add(const oroforge::mcap::Schema& schema) { return !failed() && note(writer_.add(schema)); }
    bool add(const oroforge::mcap::Channel& channel) { return !failed() && note(writer_.add(channel)); }
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

/**
 * Writes each chunk at once, to one file after another: after a Split the next one has the schemas and channels that
 * the content has then. Used by one thread at a time, but for failed().
 */
class FileSequence {
public:
    /** With `keepsOthers`, files that exist keep their names, and the numbers of later files leave them out. */
    FileSequence(const FileContent& content, const Split& split, bool keepsOthers = false);

    bool add(const oroforge::mcap::Schema& schema) { return noted(file_->add(schema)); }
    bool add(const oroforge::mcap::Channel& channel) { return noted(file_->add(channel)); }
    /** False, with an error, if the messages are lost. */
    bool write(const oroforge::mcap::Chunk& chunk);
    /** Ends the file. */
    bool finish() { return noted(file_->finish()); }
    /** Nothing more can be written. Any thread. */
    bool failed() const { return failed_.load(std::memory_order_relaxed); }
    /** What went wrong last; empty if all is well. */
    const std::string& error() const { return error_; }
    /** The bytes of all files. */
    std::uint64_t size() const { return before_ + file_->size(); }
    unsigned files() const { return files_; }

private:
    bool isFull(const oroforge::mcap::PackedChunk& next) const;
    bool noted(bool good);
    void beginNext();

    const FileContent& content_;
    const Split split_;
    const bool keepsOthers_;
    std::unique_ptr<oroforge::mcap::Compressor> compressor_;
    oroforge::mcap::PackedChunk packed_;
    std::unique_ptr<RecordFile> file_;
    std::string error_;
    unsigned number_ = 0, files_ = 1;
    std::uint64_t before_ = 0;  // bytes of the files before this one
    std::uint64_t begin_ = 0;   // the time of its first message
    bool hasMessages_ = false;  // in the file
    std::atomic<bool> failed_{false};
};

}  // namespace OCL::recording

#endif
