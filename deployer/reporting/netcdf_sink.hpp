// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_NETCDF_SINK_HPP
#define ORO_OCL_REPORTING_NETCDF_SINK_HPP

#include "netcdf_file.hpp"
#include "row_sink.hpp"

#include <memory>

namespace OCL::reporting {

/** Files up to that size are written anew when variables must grow. */
constexpr std::uint64_t kRewrittenUpTo = std::uint64_t(64) << 20;

/**
 * Writes a NetCDF file. If a row has a column, or a sequence or text has elements, that the variables have no room for,
 * the file is written anew, with more room, and takes the place of the old one. If it is larger than `rewrittenUpTo`,
 * it stays, and the rows that follow come into another one: reports.nc, reports.2.nc, …
 */
std::unique_ptr<RowSink> netcdfSink(std::unique_ptr<NetcdfFile> file, std::uint64_t rewrittenUpTo = kRewrittenUpTo);

}  // namespace OCL::reporting

#endif
