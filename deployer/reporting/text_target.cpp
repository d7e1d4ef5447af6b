// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "text_target.hpp"

#include "report_file.hpp"

#include <cerrno>
#include <ostream>
#include <string_view>
#include <sys/stat.h>
#include <unistd.h>

namespace OCL::reporting {
namespace {

/** The number of characters that belong to whole rows. A line end inside quotation marks does not end a row. */
std::size_t lastRowEnd(std::string_view rows) {
    std::size_t end = 0;
    bool quoted = false;
    for (std::size_t i = 0; i != rows.size(); ++i) {
        quoted ^= rows[i] == '"';
        if (rows[i] == '\n' && !quoted) end = i + 1;
    }
    return end;
}

class FileTarget : public TextTarget {
public:
    FileTarget(int file, std::string name) : file_(file), name_(std::move(name)) {}
    ~FileTarget() override { ::close(file_); }

    // Not buffered, so that output survives any end of this process.
    std::string write(const char* text, std::size_t size) override {
        const std::string_view lines(text, size);
        for (std::size_t written = 0; written != size;) {
            const ssize_t done = ::write(file_, text + written, size - written);
            if (done < 0 && errno == EINTR) continue;
            if (done < 0) {
                const std::string error = systemError();
                takeBack(lines.substr(0, written));
                return error;
            }
            written += static_cast<std::size_t>(done);
        }
        return {};
    }
    std::string name() const override { return "file '" + name_ + "'"; }

private:
    /** Removes the part of a row after the last whole one from a file; a pipe has passed it on. */
    void takeBack(std::string_view written) {
        const std::size_t whole = lastRowEnd(written);
        struct stat status {};
        if (whole == written.size() || ::fstat(file_, &status) != 0 || !S_ISREG(status.st_mode)) return;
        if (::ftruncate(file_, status.st_size - static_cast<off_t>(written.size() - whole)) != 0) {
            // The file then ends within a row, and the component reports the failure.
        }
    }

    const int file_;
    const std::string name_;
};

class StreamTarget : public TextTarget {
public:
    explicit StreamTarget(std::ostream& stream) : stream_(stream) {}

    std::string write(const char* text, std::size_t size) override {
        stream_.write(text, static_cast<std::streamsize>(size)).flush();
        if (stream_) return {};
        stream_.clear();  // other code also writes to it
        return "the stream does not take it";
    }
    std::string name() const override { return "the console"; }

private:
    std::ostream& stream_;
};

}  // namespace

std::unique_ptr<TextTarget> openFile(const std::string& name, std::string& error) {
    const int file = openReport(name, error);
    return std::unique_ptr<TextTarget>(file < 0 ? nullptr : new FileTarget(file, name));
}

std::unique_ptr<TextTarget> useStream(std::ostream& stream) {
    return std::unique_ptr<TextTarget>(new StreamTarget(stream));
}

}  // namespace OCL::reporting
