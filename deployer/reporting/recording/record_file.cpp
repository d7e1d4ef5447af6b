// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "record_file.hpp"

#include <reporting/report_file.hpp>
#include <rtt/Logger.hpp>

#include <algorithm>
#include <cerrno>
#include <sys/stat.h>
#include <sys/uio.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace OCL::recording {

namespace mcap = oroforge::mcap;

std::string numberedName(const std::string& file, unsigned number) {
    if (number == 0) return file;
    const std::size_t dot = file.rfind('.'), slash = file.rfind('/');
    const bool hasEnd = dot != std::string::npos && dot != 0 && (slash == std::string::npos || dot > slash + 1);
    const std::size_t at = hasEnd ? dot : file.size();
    return file.substr(0, at) + "_" + std::to_string(number) + file.substr(at);
}

/** Not buffered, so that what is written survives any end of this process. */
class RecordFile::FileSink : public mcap::Sink {
public:
    explicit FileSink(RTT::os::detail::Descriptor file) : file_(std::move(file)) {}

    bool isOpen() const { return bool(file_); }
    std::string write(const Piece* pieces, std::size_t count) override {
        std::vector<iovec> rest;
        for (const Piece* piece = pieces; piece != pieces + count; ++piece)
            if (piece->size != 0) rest.push_back({const_cast<unsigned char*>(piece->data), piece->size});
        std::uint64_t written = 0;
        for (std::size_t at = 0; at != rest.size();) {
            const ssize_t done = ::writev(file_.get(), &rest[at], static_cast<int>(rest.size() - at));
            if (done < 0 && errno == EINTR) continue;
            if (done < 0) {
                const std::string error = std::generic_category().message(errno);
                takeBack(written);
                return error;
            }
            written += static_cast<std::uint64_t>(done);
            for (auto left = static_cast<std::size_t>(done); left != 0;) {
                const std::size_t part = std::min(left, rest[at].iov_len);
                rest[at].iov_base = static_cast<char*>(rest[at].iov_base) + part;
                rest[at].iov_len -= part;
                left -= part;
                if (rest[at].iov_len == 0) ++at;
            }
        }
        return {};
    }

private:
    /** Removes part of a chunk from a file; a pipe has passed it on. */
    void takeBack(std::uint64_t written) {
        struct stat status {};
        if (written == 0 || ::fstat(file_.get(), &status) != 0 || !S_ISREG(status.st_mode)) return;
        if (::ftruncate(file_.get(), status.st_size - static_cast<off_t>(written)) != 0) {
            // A reader leaves out the part, and the failure is in the log.
        }
    }

    const RTT::os::detail::Descriptor file_;
};

RecordFile::RecordFile(const FileContent& content, const std::string& file)
    : content_(content), file_(file), sink_(new FileSink(reporting::openReport(file, error_))), writer_(*sink_) {
    if (!error_.empty()) {
        error_ = "could not open file '" + file + "' for recording: " + error_;
        return;
    }
    bool good = writer_.begin(content.header);
    for (const mcap::Schema& schema : content.schemas) good = good && writer_.add(schema);
    for (const mcap::Channel& channel : content.channels) good = good && writer_.add(channel);
    for (const mcap::Metadata& about : content.about) good = good && writer_.add(about);
    (void)note(good);
}

RecordFile::~RecordFile() = default;

bool RecordFile::note(bool good) {
    if (good || failed()) return good;
    error_ = file_ + ": byte " + std::to_string(writer_.offset()) + ": error: [" + std::string("MCP009") +
             "] the recording cannot be written: " + writer_.error() +
             "; what is in front of this byte can be read, what comes now is lost";
    return false;
}

bool RecordFile::write(const mcap::PackedChunk& chunk) { return !failed() && note(writer_.write(chunk)); }

bool RecordFile::finish() { return !failed() && note(writer_.add(content_.atEnd()) && writer_.finish()); }

FileTaker::FileTaker(const FileContent& content, const Split& split)
    : content_(content), split_(split), file_(new RecordFile(content, content.file)) {
    if (content.compression != mcap::Compression::None) compressor_.reset(new mcap::Compressor(content.compression));
    failed_ = file_->failed();
}

bool FileTaker::isFull(const mcap::PackedChunk& next) const {
    if (!hasMessages_) return false;
    const bool isLarge = split_.bytes != 0 && file_->size() + next.length() > split_.bytes;
    return isLarge || (split_.nanoseconds != 0 && next.head.start >= begin_ + split_.nanoseconds);
}

bool FileTaker::take(const mcap::Chunk& chunk) {
    if (failed_) return false;
    std::string why;
    if (!packed_.pack(chunk, compressor_.get(), why)) {
        RTT::log(RTT::Error) << "a chunk of the recording '" << content_.file << "' is lost: " << why << RTT::endlog();
        return false;
    }
    if (isFull(packed_)) {
        if (file_->finish()) file_.reset(new RecordFile(content_, numberedName(content_.file, ++number_)));
        hasMessages_ = false;
    }
    if (!hasMessages_) begin_ = packed_.head.start;
    hasMessages_ = true;
    if (file_->write(packed_)) return true;
    RTT::log(RTT::Error) << file_->error() << RTT::endlog();
    failed_ = true;
    return false;
}

void FileTaker::finish() {
    if (!failed_ && !file_->finish()) {
        RTT::log(RTT::Error) << file_->error() << RTT::endlog();
        failed_ = true;
    }
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
