// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_MCAP_TOOL_NEW_FILE_HPP
#define OROFORGE_MCAP_TOOL_NEW_FILE_HPP

#include <reporting/mcap/writer.hpp>

#include <memory>
#include <string>
#include <utility>

namespace oroforge::mcap {

/** A file that this program makes. */
class NewFile : public Sink {
public:
    /** Null, with the error on standard error, if the file exists or cannot be made. */
    static std::unique_ptr<NewFile> make(const std::string& name);
    ~NewFile() override;
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;

    /** Writes somewhere in the file. */
    std::string writeAt(std::uint64_t offset, const unsigned char* data, std::size_t size);
    std::string write(const Piece* pieces, std::size_t count) override;

private:
    explicit NewFile(int file) : file_(file) {}
    const int file_;
};

/** Lines for a new file, or for standard output. */
class LineOutput {
public:
    /** Null, with the error on standard error, if there can be no such file. Without a name: standard output. */
    static std::unique_ptr<LineOutput> make(const std::string& name);

    void write(const std::string& line);
    /** False, with the error on standard error, if the file has not got all lines. */
    bool finish();

private:
    LineOutput(std::string name, std::unique_ptr<NewFile> file) : name_(std::move(name)), file_(std::move(file)) {}
    void flush();

    const std::string name_;
    const std::unique_ptr<NewFile> file_;  // null: standard output
    std::string waiting_, error_;
};

}  // namespace oroforge::mcap

#endif
