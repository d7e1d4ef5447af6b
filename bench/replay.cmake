# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
oroforge_add_bench(replay_bench
  SOURCES ${CMAKE_CURRENT_LIST_DIR}/replay_bench.cpp
  LIBS oroforge_schedule INCLUDES ${PROJECT_SOURCE_DIR}/deployer)
