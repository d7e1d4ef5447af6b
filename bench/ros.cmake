# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
if(TARGET rtt_rostopic)
  oroforge_add_bench(ros_bench
    SOURCES ros_bench.cpp ${PROJECT_SOURCE_DIR}/tests/support/ros_master.cpp ${PROJECT_SOURCE_DIR}/tests/support/child_process.cpp
            ${PROJECT_SOURCE_DIR}/tests/support/temp_dir.cpp
    LIBS orocos-rtt rtt_rostopic
    INCLUDES ${PROJECT_SOURCE_DIR}/tests
    DEPENDS rtt-typekit)
endif()
