// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_NETCDF_LAYOUT_HPP
#define ORO_OCL_REPORTING_NETCDF_LAYOUT_HPP

#include "columns.hpp"
#include "netcdf_file.hpp"
#include "netcdf_names.hpp"

#include <cstddef>
#include <vector>

namespace OCL::reporting {

/** The variables of a NetCDF file, one for each column. There are never less, or shorter ones. */
class NetcdfLayout {
public:
    /** Adds variables for new columns, and elements: `wanted` has the number that each column needs. True for `gaps`:
        any value may be missing in a row. The file must then begin(). */
    void grow(const std::vector<Column>& columns, const std::vector<std::size_t>& wanted, bool gaps);

    std::vector<NetcdfVariable>& variables() { return variables_; }
    /** Adds a row in which everything is missing to those that wait. */
    void addRow();
    void takeBackRow();
    void clearRows();
    /** Columns whose variables have other names. */
    const std::vector<std::size_t>& renamed() const { return renamed_; }

private:
    void add(const Column& column, bool gaps);

    NetcdfNames names_, dimensions_;
    std::vector<NetcdfVariable> variables_;
    std::vector<std::size_t> renamed_;
};

}  // namespace OCL::reporting

#endif
