# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
if(TARGET rtt_rosclock)
  oroforge_add_bench(sim_clock_bench SOURCES sim_clock_bench.cpp LIBS orocos-rtt rtt_rosclock)
endif()
