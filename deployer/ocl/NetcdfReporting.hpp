// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_NETCDF_REPORTING_HPP
#define ORO_OCL_NETCDF_REPORTING_HPP

#include <ocl/ReportingComponent.hpp>

#include <string>

namespace OCL {

/**
 * Reports to a NetCDF file, which the property ReportFile names; start() begins it anew and stop() completes it.
 *
 * The unlimited dimension `time` counts the rows; each value has a variable by its dotted name. With the property
 * Decompose, an element of a sequence has a variable of its own; without it, a sequence of numbers is one variable with
 * a second dimension. Members of structs always have variables of their own.
 *
 * The component's thread never waits for the disk: between start() and stop(), a separate thread makes the file. If
 * that cannot go on, the log has an error, the attribute LostRows counts the rows that are lost, and the component
 * enters the state RunTimeError until it is stopped and started.
 */
class OCL_API NetcdfReporting : public ReportingComponent {
public:
    explicit NetcdfReporting(const std::string& name = "NetcdfReporting");
    ~NetcdfReporting() override;

protected:
    /** False, with an error in the log, if the file cannot be opened, another reporter writes to it, or the library of
        NetCDF is not installed. */
    bool startHook() override;

private:
    std::string reportFile_ = "reports.nc";
};

}  // namespace OCL

#endif
