# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# What executes components in simulated time, in one thread, when a recording is replayed.
add_library(oroforge_schedule STATIC
  schedule/agenda.cpp
  schedule/replaced_activity.cpp
  schedule/schedule.cpp
  schedule/scheduled_activity.cpp
  schedule/scheduled_thread.cpp
  schedule/stand_ins.cpp)
target_include_directories(oroforge_schedule PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(oroforge_schedule PUBLIC orocos-rtt)
set_target_properties(oroforge_schedule PROPERTIES POSITION_INDEPENDENT_CODE ON)
target_link_libraries(oroforge_deployer_program PUBLIC oroforge_schedule)
