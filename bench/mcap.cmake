# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
if(TARGET orocos-ocl-reporting-mcap)
  oroforge_add_bench(mcap_bench SOURCES mcap_bench.cpp LIBS orocos-ocl-replay orocos-ocl-reporting-mcap oroforge_mcap
    DEFINITIONS RTT_TYPEKIT_FILE="$<TARGET_FILE:rtt-typekit>" DEPENDS rtt-typekit)
endif()
