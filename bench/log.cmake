# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
oroforge_add_bench(log_bench SOURCES log_bench.cpp LIBS orocos-rtt)
add_executable(runtime_probe EXCLUDE_FROM_ALL runtime_probe.cpp)
target_link_libraries(runtime_probe PRIVATE orocos-rtt)
oroforge_add_bench(runtime_bench SOURCES runtime_bench.cpp LIBS orocos-rtt DEPENDS runtime_probe rtt-typekit
  DEFINITIONS RUNTIME_PROBE="$<TARGET_FILE:runtime_probe>")
