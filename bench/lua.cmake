# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
if(TARGET orocos-ocl-lua)
  oroforge_add_bench(lua_bench SOURCES lua_bench.cpp LIBS orocos-ocl-lua orocos-rtt
    DEFINITIONS RTT_TYPEKIT_FILE="$<TARGET_FILE:rtt-typekit>" DEPENDS rtt-typekit)
endif()
