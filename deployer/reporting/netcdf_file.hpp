// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_NETCDF_FILE_HPP
#define ORO_OCL_REPORTING_NETCDF_FILE_HPP

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace OCL::reporting {

/**
 * A NetCDF file to which records are appended. Whenever this process ends, the file has all records that append() has
 * taken: the number in its head is changed after they are written. Errors are returned as text, empty if there is none.
 */
class NetcdfFile {
public:
    /** Makes it, or begins it anew; null and an error if that fails or another reporter writes to it. */
    static std::unique_ptr<NetcdfFile> open(const std::string& name, std::string& error);
    ~NetcdfFile();
    NetcdfFile(const NetcdfFile&) = delete;
    NetcdfFile& operator=(const NetcdfFile&) = delete;

    /** Writes the head of a file without records. */
    std::string begin(const std::string& header, std::size_t recordSize);
    /** Appends whole records. After an error, the file ends with the last one that had room, and `written` tells how
        many there were. */
    std::string append(const std::string& records, std::size_t& written);
    /** Reads records; fewer at the end of the file. */
    std::string read(std::uint64_t first, std::size_t count, std::string& records) const;
    /** Writes over a part of the head. */
    std::string change(std::size_t place, const std::string& bytes);

    /** The error, if the name does not lead to this file any more. */
    std::string lost() const;
    /** Takes the name and the permissions of another file, which then has no name. */
    std::string replace(NetcdfFile& other);

    std::uint64_t records() const { return records_; }
    std::uint64_t size() const { return begin_ + records_ * recordSize_; }
    /** Absolute, without symbolic links. */
    const std::string& path() const { return path_; }

private:
    NetcdfFile(int file, std::string path) : file_(file), path_(std::move(path)) {}
    std::string setRecords(std::uint64_t number);

    const int file_;
    std::string path_;
    std::uint64_t begin_ = 0;  // of the records
    std::size_t recordSize_ = 0;
    std::uint64_t records_ = 0;
};

}  // namespace OCL::reporting

#endif
