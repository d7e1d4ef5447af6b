# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# The reporter that writes NetCDF files. Left out where libnetcdf is not installed.
find_package(PkgConfig REQUIRED)
pkg_check_modules(NETCDF IMPORTED_TARGET netcdf)
if(NOT NETCDF_FOUND)
  message(STATUS "the library of NetCDF (libnetcdf-dev) is not installed: no reports as NetCDF files")
  return()
endif()

# Nobody imports it: the component type loads it when a reporter starts (reporting/netcdf_writer.hpp).
add_library(ocl-netcdf-writer SHARED
  reporting/netcdf_file.cpp
  reporting/netcdf_layout.cpp
  reporting/netcdf_names.cpp
  reporting/netcdf_row.cpp
  reporting/netcdf_sink.cpp)
target_link_libraries(ocl-netcdf-writer PUBLIC orocos-ocl-reporting PkgConfig::NETCDF)
set_target_properties(ocl-netcdf-writer PROPERTIES
  OUTPUT_NAME ocl-netcdf-writer-${OROCOS_TARGET}
  LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${OROFORGE_PLUGIN_DIR}/ocl/netcdf
  BUILD_RPATH_USE_ORIGIN ON
  INSTALL_RPATH "$ORIGIN/../../../..;$ORIGIN/..")
install(TARGETS ocl-netcdf-writer LIBRARY DESTINATION ${OROFORGE_PLUGIN_DIR}/ocl/netcdf COMPONENT netcdf)

oroforge_component_library(reporting-netcdf reporting/NetcdfReporting.cpp)
target_link_libraries(orocos-ocl-reporting-netcdf PUBLIC orocos-ocl-reporting)
add_dependencies(orocos-ocl-reporting-netcdf ocl-netcdf-writer)
