// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_NETCDF_FILE_HPP
#define ORO_OCL_REPORTING_NETCDF_FILE_HPP

#include <cstddef>
#include <cstdint>
#include <memory>
#include <netcdf.h>
#include <string>
#include <vector>

namespace OCL::reporting {

/** Rows are written when they are about as long as the library's buffer: blocks beyond it would be read and written for
    each variable. */
constexpr std::size_t kNetcdfBlock = 32 * 1024;

struct NetcdfText {
    std::string name, value;
};

/** A variable of a file, and its values of the rows that wait. */
struct NetcdfVariable {
    std::string name;
    nc_type type = NC_DOUBLE;
    std::size_t bytes = 8;     ///< of an element
    std::string dimension;     ///< besides time; empty for one value per row
    std::size_t elements = 1;  ///< of that dimension
    std::vector<NetcdfText> texts;
    std::vector<long long> flags;
    bool hasFill = true;  ///< an attribute says that the fill value is none of the data

    /** What a row has here before values are put into it: the fill value for each element. Set by begin(). */
    std::string empty;
    std::string waiting;  ///< as in memory, row after row
};

/**
 * A NetCDF file to which rows are appended. Whenever this process ends, the file has all rows that append() has taken:
 * the number in its head is changed after they are written. Errors are returned as text, empty if there is none.
 */
class NetcdfFile {
public:
    /** Makes it, or empties it; null and an error if that fails or another reporter writes to it. */
    static std::unique_ptr<NetcdfFile> open(const std::string& name, std::string& error);
    ~NetcdfFile();
    NetcdfFile(const NetcdfFile&) = delete;
    NetcdfFile& operator=(const NetcdfFile&) = delete;

    /** Begins the file, anew if it was begun already, without rows. */
    std::string begin(std::vector<NetcdfVariable>& variables, const std::vector<NetcdfText>& attributes);
    /** Appends the rows that wait; after an error, none of them. */
    std::string append(const std::vector<NetcdfVariable>& variables, std::size_t rows);
    /** Takes the rows of a file with less variables, or shorter ones. This file has none yet. */
    std::string copy(const NetcdfFile& from);
    /** Changes an attribute to another text of the same length. */
    std::string change(const NetcdfText& attribute);

    /** The error, if the name does not lead to this file any more. */
    std::string lost() const;
    /** Takes the name and the permissions of another file, which then has no name. */
    std::string replace(NetcdfFile& other);

    std::size_t rows() const { return rows_; }
    std::size_t rowSize() const { return rowSize_; }
    std::uint64_t size() const { return begin_ + std::uint64_t(rows_) * rowSize_; }
    /** Absolute, without symbolic links. */
    const std::string& path() const { return path_; }

private:
    NetcdfFile(int file, std::string path) : file_(file), path_(std::move(path)) {}
    void define(NetcdfVariable& variable, int time);
    std::string reserve(std::size_t rows);

    const int file_;
    std::string path_;
    int id_ = -1;              // of the library
    std::uint64_t begin_ = 0;  // of the rows
    std::size_t rowSize_ = 0;
    std::size_t rows_ = 0;
    std::vector<std::size_t> elements_;  // of each variable
};

}  // namespace OCL::reporting

#endif
