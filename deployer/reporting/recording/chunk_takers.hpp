// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_RECORDING_CHUNK_TAKERS_HPP
#define OROFORGE_RECORDING_CHUNK_TAKERS_HPP

#include "chunk_pipe.hpp"

#include <reporting/mcap_file/record_file.hpp>

#include <cstdint>
#include <deque>
#include <memory>
#include <string>

namespace OCL::recording {

/** Writes each chunk at once, and logs what goes wrong. */
class FileTaker : public ChunkTaker {
public:
    FileTaker(const FileContent& content, const Split& split) : files_(content, split) {}
    /** Why the first file could not be begun; empty if all is well. */
    const std::string& error() const { return files_.error(); }

    bool take(const oroforge::mcap::Chunk& chunk) override;
    /** Ends the file. Called when the thread of the pipe has ended. */
    void finish();
    bool failed() const { return files_.failed(); }

private:
    FileSequence files_;
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
