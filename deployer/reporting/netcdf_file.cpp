// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "netcdf_file.hpp"

#include "report_file.hpp"

#include <rtt/os/own_file.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <mutex>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace OCL::reporting {
namespace {

struct Failure {
    int status;
};

void must(int status) {
    if (status != NC_NOERR) throw Failure{status};
}

/** The library is not safe for two threads, even with two files. */
std::mutex library;

template <class Work>
std::string call(Work work) {
    const std::lock_guard<std::mutex> lock(library);
    try {
        work();
        return {};
    } catch (const Failure& failure) {
        return nc_strerror(failure.status);
    }
}

void put(int file, int variable, const NetcdfText& text) {
    must(nc_put_att_text(file, variable, text.name.c_str(), text.value.size(), text.value.data()));
}

constexpr std::uint64_t roundedUp(std::uint64_t size, std::uint64_t unit) { return (size + unit - 1) / unit * unit; }

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

NetcdfFile::~NetcdfFile() {
    if (id_ >= 0) (void)call([this] { must(nc_close(id_)); });  // all rows are written before
    ::close(file_);
}

std::string NetcdfFile::begin(std::vector<NetcdfVariable>& variables, const std::vector<NetcdfText>& attributes) {
    rows_ = rowSize_ = 0;
    elements_.clear();
    std::size_t block = kNetcdfBlock;
    std::string error = call([&] {
        if (id_ >= 0) must(nc_close(std::exchange(id_, -1)));
        // The library opens files by name, and takes some names for a URL or a path of Windows. This one is the file
        // that open() has opened, whatever has become of its name.
        const std::string name = "/proc/self/fd/" + std::to_string(file_);
        must(nc__create(name.c_str(), NC_64BIT_DATA, 0, &block, &id_));
        int time = 0;
        must(nc_def_dim(id_, "time", NC_UNLIMITED, &time));
        for (const NetcdfText& attribute : attributes) put(id_, NC_GLOBAL, attribute);
        for (NetcdfVariable& variable : variables) define(variable, time);
        // The buffer has two blocks at most. So no row shares it with the head, and the number of rows in the head is
        // never written before the rows.
        must(nc__enddef(id_, 0, 4, 0, 2 * block));
        must(nc_sync(id_));
    });
    struct stat status {};
    if (error.empty() && ::fstat(file_, &status) != 0) error = systemError();
    begin_ = roundedUp(static_cast<std::uint64_t>(status.st_size), 2 * block);
    return error;
}

void NetcdfFile::define(NetcdfVariable& variable, int time) {
    int dimensions[] = {time, 0};
    const bool isLong = !variable.dimension.empty();
    if (isLong) must(nc_def_dim(id_, variable.dimension.c_str(), variable.elements, &dimensions[1]));
    int id = 0;
    must(nc_def_var(id_, variable.name.c_str(), variable.type, isLong ? 2 : 1, dimensions, &id));
    for (const NetcdfText& text : variable.texts) put(id_, id, text);
    if (!variable.flags.empty())
        must(nc_put_att_longlong(id_, id, "flag_values", variable.type, variable.flags.size(), variable.flags.data()));
    int isOff = 0;
    char fill[sizeof(std::uint64_t)];
    must(nc_inq_var_fill(id_, id, &isOff, fill));
    if (variable.hasFill) must(nc_put_att(id_, id, "_FillValue", variable.type, 1, fill));
    variable.empty.clear();
    variable.empty.reserve(variable.elements * variable.bytes);
    for (std::size_t i = 0; i != variable.elements; ++i) variable.empty.append(fill, variable.bytes);
    elements_.push_back(variable.elements);
    rowSize_ += roundedUp(variable.empty.size(), 4);
}

/** Makes the file longer. On a full disk, the library would write the head of rows that are not there. */
std::string NetcdfFile::reserve(std::size_t rows) {
    if (rows == 0) return {};
    int error = EINTR;
    while (error == EINTR)
        error = ::posix_fallocate(file_, static_cast<off_t>(size()), static_cast<off_t>(rows * rowSize_));
    if (error == 0) return {};
    std::string text = std::generic_category().message(error);
    if (::ftruncate(file_, static_cast<off_t>(size())) != 0) text += ", " + systemError();
    return text;
}

std::string NetcdfFile::append(const std::vector<NetcdfVariable>& variables, std::size_t rows) {
    if (std::string error = reserve(rows); !error.empty()) return error;
    std::string error = call([&] {
        must(nc_set_fill(id_, NC_NOFILL, nullptr));  // every row has all variables
        int id = 0;
        for (const NetcdfVariable& variable : variables) {
            const std::size_t begin[] = {rows_, 0}, count[] = {rows, variable.elements};
            must(nc_put_vara(id_, id++, begin, count, variable.waiting.data()));
        }
        must(nc_sync(id_));
    });
    if (error.empty()) rows_ += rows;
    return error;
}

std::string NetcdfFile::copy(const NetcdfFile& from) {
    if (std::string error = reserve(from.rows_); !error.empty()) return error;
    const std::size_t some = std::max<std::size_t>(1, kNetcdfBlock / rowSize_);
    std::string values(some * from.rowSize_, '\0');
    std::string error = call([&] {
        for (std::size_t row = 0; row < from.rows_; row += some)
            for (std::size_t i = 0; i != from.elements_.size(); ++i) {
                const std::size_t begin[] = {row, 0}, count[] = {std::min(some, from.rows_ - row), from.elements_[i]};
                must(nc_get_vara(from.id_, static_cast<int>(i), begin, count, values.data()));
                must(nc_put_vara(id_, static_cast<int>(i), begin, count, values.data()));
            }
        must(nc_sync(id_));
    });
    if (error.empty()) rows_ = from.rows_;
    return error;
}

std::string NetcdfFile::change(const NetcdfText& attribute) {
    return call([&] {
        put(id_, NC_GLOBAL, attribute);
        must(nc_sync(id_));
    });
}

std::string NetcdfFile::lost() const {
    struct stat mine {};
    struct stat named {};
    if (::fstat(file_, &mine) != 0) return systemError();
    if (::stat(path_.c_str(), &named) != 0) return errno == ENOENT ? "somebody has removed it" : systemError();
    if (mine.st_dev != named.st_dev || mine.st_ino != named.st_ino) return "somebody has put another file in its place";
    return rows_ != 0 && static_cast<std::uint64_t>(mine.st_size) < size() ? "somebody has made it shorter" : "";
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
