# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
oroforge_add_bench(replay_bench
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/replay_bench.cpp
  LIBS oroforge_schedule INCLUDES ${PROJECT_SOURCE_DIR}/deployer)
if(TARGET orocos-ocl-reporting-mcap)
  target_link_libraries(replay_bench PRIVATE orocos-ocl-reporting-mcap)
  target_compile_definitions(replay_bench PRIVATE HAS_RECORDER RTT_TYPEKIT_FILE="$<TARGET_FILE:rtt-typekit>")
  add_dependencies(replay_bench rtt-typekit)
endif()
