// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Records to a file, which may be begun anew.
#ifndef OROFORGE_LOGGING_FILE_LINES_HPP
#define OROFORGE_LOGGING_FILE_LINES_HPP

#include "fd_lines.hpp"

#include <cstdint>
#include <string>

namespace OCL::logging {

class FileLines : public FdLines {
public:
    FileLines(const std::string& owner, std::string file);
    ~FileLines() override;

    /** False, with an error logged, if the file cannot be opened. */
    bool open();
    void closeFile();

protected:
    bool prepare(std::string& error) override;
    std::string target() const override { return "file '" + name_ + "'"; }
    /** Opens the file; the reason if that fails. */
    std::string tryToOpen(bool empty = false);
    /** Ends a line that a crash of the machine, or another program, has left without its end. */
    void endTornLine();
    /** Reports that the file was not begun anew, once. */
    void keptOn(const std::string& reason);

    const std::string name_;

private:
    bool keepsOn_ = false;
};

/** As log4cpp's RollingFileAppender: begun anew when it has so many bytes. */
class RollingFileLines final : public FileLines {
public:
    RollingFileLines(const std::string& owner, std::string file, std::uint64_t size, unsigned backups);

private:
    void write(const log4cpp::LoggingEvent& event, const std::string& record) override;
    void rollOver();
    std::string backup(unsigned index) const;

    const std::uint64_t size_;
    const unsigned backups_;
    std::uint64_t rollAt_;
};

/** Begun anew on demand; the former file gets the next free number. */
class GenerationalFileLines final : public FileLines {
public:
    using FileLines::FileLines;
    void advance();
};

}  // namespace OCL::logging

#endif
