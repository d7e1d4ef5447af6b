// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "netcdf_file.hpp"

#include "classic_header.hpp"
#include "report_file.hpp"

#include <rtt/os/own_file.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace OCL::reporting {
namespace {

/** Writes all of it; `done` tells how much that was. */
std::string writeAt(int file, const std::string& bytes, std::uint64_t place, std::size_t& done) {
    for (done = 0; done != bytes.size();) {
        const ssize_t part = ::pwrite(file, bytes.data() + done, bytes.size() - done, static_cast<off_t>(place + done));
        if (part < 0 && errno == EINTR) continue;
        if (part < 0) return systemError();
        done += static_cast<std::size_t>(part);
    }
    return {};
}

}  // namespace

std::unique_ptr<NetcdfFile> NetcdfFile::open(const std::string& name, std::string& error) {
    // Without O_NONBLOCK, opening a pipe would wait for somebody who reads from it.
    const int file = RTT::os::detail::openOwnFile(name.c_str(), O_RDWR | O_CREAT | O_NONBLOCK);
    if (file < 0) {
        error = RTT::os::detail::openError(errno);
        return nullptr;
    }
    std::error_code failure;
    std::unique_ptr<NetcdfFile> result(new NetcdfFile(file, std::filesystem::canonical(name, failure).string()));
    error = !isRegular(file) ? "it is not an ordinary file" : claim(file);
    if (error.empty() && failure) error = failure.message();
    if (!error.empty()) result.reset();
    return result;
}

NetcdfFile::~NetcdfFile() { ::close(file_); }

std::string NetcdfFile::begin(const std::string& header, std::size_t recordSize) {
    if (::ftruncate(file_, 0) != 0) return systemError();
    begin_ = header.size();
    recordSize_ = recordSize;
    records_ = 0;
    std::size_t done = 0;
    return writeAt(file_, header, 0, done);
}

std::string NetcdfFile::append(const std::string& records, std::size_t& written) {
    std::size_t done = 0;
    std::string error = writeAt(file_, records, size(), done);
    written = done / recordSize_;
    if (const std::string next = setRecords(records_ + written); !next.empty()) return error.empty() ? next : error;
    if (!error.empty() && ::ftruncate(file_, static_cast<off_t>(size())) != 0) error += ", " + systemError();
    return error;
}

std::string NetcdfFile::setRecords(std::uint64_t number) {
    std::string bytes;
    appendBig(bytes, ClassicType::UInt64, number);
    std::string error = change(kRecordCountPlace, bytes);
    if (error.empty()) records_ = number;
    return error;
}

std::string NetcdfFile::change(std::size_t place, const std::string& bytes) {
    std::size_t done = 0;
    return writeAt(file_, bytes, place, done);
}

std::string NetcdfFile::read(std::uint64_t first, std::size_t count, std::string& records) const {
    records.resize(static_cast<std::size_t>(std::min<std::uint64_t>(count, records_ - first)) * recordSize_);
    for (std::size_t done = 0; done != records.size();) {
        const ssize_t part = ::pread(file_, records.data() + done, records.size() - done,
                                     static_cast<off_t>(begin_ + first * recordSize_ + done));
        if (part < 0 && errno == EINTR) continue;
        if (part < 0) return systemError();
        if (part == 0) return "somebody has made it shorter";
        done += static_cast<std::size_t>(part);
    }
    return {};
}

std::string NetcdfFile::lost() const {
    struct stat mine {};
    struct stat named {};
    if (::fstat(file_, &mine) != 0) return systemError();
    if (::stat(path_.c_str(), &named) != 0) return errno == ENOENT ? "somebody has removed it" : systemError();
    if (mine.st_dev != named.st_dev || mine.st_ino != named.st_ino) return "somebody has put another file in its place";
    return static_cast<std::uint64_t>(mine.st_size) < size() ? "somebody has made it shorter" : "";
}

std::string NetcdfFile::replace(NetcdfFile& other) {
    struct stat status {};
    if (::fstat(other.file_, &status) == 0) (void)::fchmod(file_, status.st_mode & 07777U);
    if (std::string error = other.lost(); !error.empty()) return error;
    if (std::rename(path_.c_str(), other.path_.c_str()) != 0) return systemError();
    path_ = other.path_;
    return {};
}

}  // namespace OCL::reporting
