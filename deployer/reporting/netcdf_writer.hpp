// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The module that writes NetCDF files. It alone is linked with libnetcdf, and loaded when a reporter starts: in every
// process that imports `ocl`, loading that library would cost 9 to 20 ms and 8 MB.
#ifndef ORO_OCL_REPORTING_NETCDF_WRITER_HPP
#define ORO_OCL_REPORTING_NETCDF_WRITER_HPP

#include "row_sink.hpp"

#include <string>

/** Opens the file; null and an error if that fails. The caller owns the sink. */
extern "C" OCL::reporting::RowSink* oclNetcdfSink(const std::string& file, std::string& error);

#endif
