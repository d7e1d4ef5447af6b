// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "source.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace oroforge::mcap {
namespace {

class FileSource : public Source {
public:
    FileSource(int file, std::uint64_t size) : file_(file), size_(size) {}
    ~FileSource() override { ::close(file_); }
    FileSource(const FileSource&) = delete;
    FileSource& operator=(const FileSource&) = delete;

    std::uint64_t size() const override { return size_; }
    bool read(std::uint64_t offset, void* to, std::size_t size) override {
        for (std::size_t done = 0; done != size;) {
            const ssize_t got =
                ::pread(file_, static_cast<char*>(to) + done, size - done, static_cast<off_t>(offset + done));
            if (got < 0 && errno == EINTR) continue;
            if (got <= 0) return false;  // 0: it has been truncated since it was opened
            done += static_cast<std::size_t>(got);
        }
        return true;
    }

private:
    const int file_;
    const std::uint64_t size_;
};

}  // namespace

bool MemorySource::read(std::uint64_t offset, void* to, std::size_t size) {
    if (offset > size_ || size > size_ - offset) return false;
    if (size != 0) std::memcpy(to, data_ + offset, size);
    return true;
}

std::unique_ptr<Source> openSource(const std::string& file, std::string& why) {
    const int opened = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);  // a pipe would wait for a writer
    struct stat status {};
    if (opened >= 0 && ::fstat(opened, &status) == 0 && S_ISREG(status.st_mode))
        return std::unique_ptr<Source>(new FileSource(opened, static_cast<std::uint64_t>(status.st_size)));
    why = opened < 0 ? std::generic_category().message(errno) : "it is not a regular file";
    if (opened >= 0) ::close(opened);
    return nullptr;
}

}  // namespace oroforge::mcap
