// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_NETCDF_NAMES_HPP
#define ORO_OCL_REPORTING_NETCDF_NAMES_HPP

#include <string>
#include <unordered_set>

namespace OCL::reporting {

/** Names as NetCDF allows them, each given once. */
class NetcdfNames {
public:
    /**
     * The name itself, if possible. A character that NetCDF or one of its tools forbids becomes `_`, a name that is too
     * long loses its end, and one that is taken gets a number.
     */
    std::string take(const std::string& wanted);

private:
    std::unordered_set<std::string> taken_;
};

}  // namespace OCL::reporting

#endif
