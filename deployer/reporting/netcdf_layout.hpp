// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_NETCDF_LAYOUT_HPP
#define ORO_OCL_REPORTING_NETCDF_LAYOUT_HPP

#include "classic_header.hpp"
#include "columns.hpp"
#include "netcdf_names.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace OCL::reporting {

/**
 * The variables of a NetCDF file, and the place that each one has in a record. It only grows: a record of an earlier
 * layout can be turned into one of a later layout.
 */
class NetcdfLayout {
public:
    struct Place {
        std::size_t begin = 0;     // in the record
        std::size_t bytes = 0;     // without padding
        std::size_t elements = 1;  // numbers, or letters of a text
        ClassicType type = ClassicType::Double;
    };

    /** Adds variables for new columns, and room: `wanted` has the elements that each column needs. True for `gaps`: any
        value may be missing in a row. */
    void grow(const std::vector<Column>& columns, const std::vector<std::size_t>& wanted, bool gaps);

    const std::vector<Place>& places() const { return places_; }
    const std::vector<ClassicVariable>& variables() const { return variables_; }
    /** A record in which everything is missing. */
    const std::string& emptyRecord() const { return empty_; }
    std::size_t recordSize() const { return empty_.size(); }
    /** Appends a record of an earlier layout. */
    void appendConverted(std::string& to, const char* record, const std::vector<Place>& earlier) const;
    /** Columns whose variables have other names. */
    const std::vector<std::size_t>& renamed() const { return renamed_; }

private:
    void add(const Column& column, bool gaps);

    NetcdfNames names_, dimensions_;
    std::vector<ClassicVariable> variables_;
    std::vector<Place> places_;
    std::vector<std::size_t> renamed_;
    std::string empty_;
};

}  // namespace OCL::reporting

#endif
