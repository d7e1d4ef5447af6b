# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
oroforge_add_bench(reporting_bench SOURCES reporting_bench.cpp LIBS orocos-ocl-reporting
  DEFINITIONS RTT_TYPEKIT_FILE="$<TARGET_FILE:rtt-typekit>" DEPENDS rtt-typekit)
if(TARGET orocos-ocl-reporting-netcdf)
  oroforge_add_bench(netcdf_bench SOURCES netcdf_bench.cpp LIBS orocos-ocl-reporting-netcdf
    DEFINITIONS RTT_TYPEKIT_FILE="$<TARGET_FILE:rtt-typekit>" DEPENDS rtt-typekit)
endif()
