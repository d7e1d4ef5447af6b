// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_NETCDF_ROW_HPP
#define ORO_OCL_REPORTING_NETCDF_ROW_HPP

#include "netcdf_layout.hpp"

#include <string_view>
#include <vector>

namespace OCL::reporting {

/** Puts the values of a row into the variables of a NetCDF file, and finds out what has no room there. */
class NetcdfRow : public ValueTaker {
public:
    NetcdfRow(const Columns& columns, NetcdfLayout& layout) : columns_(columns), layout_(layout) {}

    /** The values that follow belong to a new row. */
    void begin();
    /** True if a value had no room. */
    bool isCut() const { return cut_; }
    /** The elements that each column has needed. */
    const std::vector<std::size_t>& wanted() const { return wanted_; }

    void value(std::size_t column, Tag tag, RecordReader& record) override;
    void elements(std::size_t column, std::uint32_t count, RecordReader& record) override;
    void count(std::size_t column, std::uint32_t count) override;

private:
    /** Where the elements of the column begin in this row; null if there is no room for so many. */
    char* room(std::size_t column, std::size_t elements);
    void putText(std::size_t column, std::string_view text);
    void putOther(std::size_t column, RecordReader& record);
    void putNumber(std::size_t column, std::uint64_t bits);

    const Columns& columns_;
    NetcdfLayout& layout_;
    bool cut_ = false;
    std::vector<std::size_t> wanted_;
};

}  // namespace OCL::reporting

#endif
