# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
oroforge_add_bench(reporting_bench SOURCES reporting_bench.cpp LIBS orocos-ocl-reporting-netcdf
  DEFINITIONS RTT_TYPEKIT_FILE="$<TARGET_FILE:rtt-typekit>" DEPENDS rtt-typekit)
