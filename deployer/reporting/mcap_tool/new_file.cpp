// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "new_file.hpp"

#include <cerrno>
#include <fcntl.h>
#include <iostream>
#include <system_error>
#include <unistd.h>

namespace oroforge::mcap {

std::unique_ptr<NewFile> NewFile::make(const std::string& name) {
    constexpr mode_t kMode = 0666;
    const int file = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kMode);
    if (file >= 0) return std::unique_ptr<NewFile>(new NewFile(file));
    const std::string why = errno == EEXIST ? "the file exists; remove it, or name another one with -o"
                                            : std::generic_category().message(errno);
    std::cerr << name << ": error: " << why << "\n";
    return nullptr;
}

NewFile::~NewFile() { ::close(file_); }

std::string NewFile::writeAt(std::uint64_t offset, const unsigned char* data, std::size_t size) {
    for (std::size_t done = 0; done != size;) {
        const ssize_t written = ::pwrite(file_, data + done, size - done, static_cast<off_t>(offset + done));
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return std::generic_category().message(errno);
        done += static_cast<std::size_t>(written);
    }
    return {};
}

std::string NewFile::write(const Piece* pieces, std::size_t count) {
    for (const Piece* piece = pieces; piece != pieces + count; ++piece)
        for (std::size_t done = 0; done != piece->size;) {
            const ssize_t size = ::write(file_, piece->data + done, piece->size - done);
            if (size < 0 && errno == EINTR) continue;
            if (size < 0) return std::generic_category().message(errno);
            done += static_cast<std::size_t>(size);
        }
    return {};
}

std::unique_ptr<LineOutput> LineOutput::make(const std::string& name) {
    std::unique_ptr<NewFile> file;
    if (!name.empty() && !(file = NewFile::make(name))) return nullptr;
    return std::unique_ptr<LineOutput>(new LineOutput(name, std::move(file)));
}

void LineOutput::write(const std::string& line) {
    constexpr std::size_t kAtOnce = 65536;
    if (!file_) {
        std::cout << line;
        return;
    }
    waiting_ += line;
    if (waiting_.size() >= kAtOnce) flush();
}

void LineOutput::flush() {
    const Sink::Piece piece = {reinterpret_cast<const unsigned char*>(waiting_.data()), waiting_.size()};
    if (error_.empty()) error_ = file_->write(&piece, 1);
    waiting_.clear();
}

bool LineOutput::finish() {
    if (file_) flush();
    if (!error_.empty()) std::cerr << name_ << ": error: " << error_ << "\n";
    return error_.empty();
}

}  // namespace oroforge::mcap
