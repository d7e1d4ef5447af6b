// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_NETCDF_ROW_HPP
#define ORO_OCL_REPORTING_NETCDF_ROW_HPP

#include "netcdf_layout.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace OCL::reporting {

/** Puts the values of a row into a record of a NetCDF file, and finds out what has no room there. */
class NetcdfRow : public ValueTaker {
public:
    NetcdfRow(const Columns& columns, const NetcdfLayout& layout) : columns_(columns), layout_(layout) {}

    /** The values that follow belong to a new record at the end of `records`. */
    void begin(std::string& records);
    /** True if a value had no room. */
    bool isCut() const { return cut_; }
    /** The elements that each column has needed at most. */
    const std::vector<std::size_t>& wanted() const { return wanted_; }

    void value(std::size_t column, Tag tag, RecordReader& record) override;
    void elements(std::size_t column, std::uint32_t count, RecordReader& record) override;
    void count(std::size_t column, std::uint32_t count) override;

private:
    /** The place of the column; null if it has none, or not as many elements. */
    const NetcdfLayout::Place* room(std::size_t column, std::size_t elements);
    void putText(std::size_t column, std::string_view text);
    void putOther(std::size_t column, RecordReader& record);
    void putNumber(const NetcdfLayout::Place* place, std::size_t element, std::uint64_t bits);

    const Columns& columns_;
    const NetcdfLayout& layout_;
    std::string* records_ = nullptr;
    std::size_t begin_ = 0;  // of the record
    bool cut_ = false;
    std::vector<std::size_t> wanted_;
};

}  // namespace OCL::reporting

#endif
