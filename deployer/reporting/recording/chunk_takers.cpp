// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "chunk_takers.hpp"

#include <rtt/Logger.hpp>

#include <utility>

namespace OCL::recording {

namespace mcap = oroforge::mcap;

bool FileTaker::take(const mcap::Chunk& chunk) {
    if (files_.failed()) return false;
    if (files_.write(chunk)) return true;
    RTT::log(RTT::Error) << files_.error() << RTT::endlog();
    return false;
}

void FileTaker::finish() {
    if (!files_.failed() && !files_.finish()) RTT::log(RTT::Error) << files_.error() << RTT::endlog();
}

LastChunks::LastChunks(const FileContent& content, double seconds, std::uint64_t bytes)
    : content_(content), span_(static_cast<std::uint64_t>(seconds * 1e9)), most_(bytes) {
    if (content.compression != mcap::Compression::None) compressor_.reset(new mcap::Compressor(content.compression));
}

LastChunks::Packed LastChunks::takeOldest() {
    Packed oldest = std::move(chunks_.front());
    chunks_.pop_front();
    size_ -= memoryOf(*oldest);
    return oldest;
}

std::uint64_t LastChunks::memoryOf(const mcap::PackedChunk& chunk) {
    return chunk.before.capacity() + chunk.packed.capacity() + chunk.after.capacity() + sizeof chunk;
}

bool LastChunks::take(const mcap::Chunk& chunk) {
    // The memory of a chunk that is too old is used again.
    Packed packed;
    const std::uint64_t begin = chunk.end() > span_ ? chunk.end() - span_ : 0;
    while (!chunks_.empty() && chunks_.front()->head.end < begin) packed = takeOldest();
    if (!packed) packed.reset(new mcap::PackedChunk);
    std::string why;
    if (!packed->pack(chunk, compressor_.get(), why)) {
        RTT::log(RTT::Error) << "a chunk of the recording '" << content_.file << "' is lost: " << why << RTT::endlog();
        return false;
    }
    packed->own();
    size_ += memoryOf(*packed);
    chunks_.push_back(std::move(packed));
    while (size_ > most_ && chunks_.size() > 1) {
        (void)takeOldest();
        if (std::exchange(isShort_, true)) continue;
        RTT::log(RTT::Warning) << "the ring of the recording '" << content_.file << "' has less than "
                               << static_cast<double>(span_) / 1e9 << " seconds: they need more than the " << most_
                               << " bytes of the property RingSize" << RTT::endlog();
    }
    return true;
}

bool LastChunks::save() {
    const std::string name = numberedName(content_.file, number_++);
    RecordFile file(content_, name);
    bool good = !file.failed();
    for (const auto& chunk : chunks_) good = good && file.write(*chunk);
    if (good && file.finish()) {
        RTT::log(RTT::Info) << "the last " << chunks_.size() << " chunks are in '" << name << "'" << RTT::endlog();
        return true;
    }
    RTT::log(RTT::Error) << file.error() << RTT::endlog();
    return false;
}

}  // namespace OCL::recording
