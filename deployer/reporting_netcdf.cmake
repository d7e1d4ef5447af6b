# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# The reporter that writes NetCDF files. It makes the bytes itself (docs/design/reports.md), so it needs no library of NetCDF.
oroforge_component_library(reporting-netcdf
  reporting/NetcdfReporting.cpp
  reporting/classic_header.cpp
  reporting/netcdf_file.cpp
  reporting/netcdf_layout.cpp
  reporting/netcdf_names.cpp
  reporting/netcdf_row.cpp
  reporting/netcdf_sink.cpp)
target_link_libraries(orocos-ocl-reporting-netcdf PUBLIC orocos-ocl-reporting)
