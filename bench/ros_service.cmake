# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
set(folder ${PROJECT_SOURCE_DIR}/tests/unit/ros_service)
find_path(STD_SRVS_INCLUDE_DIR std_srvs/SetBool.h)
if(TARGET rtt_rosservice AND TARGET oroforge_test_support AND STD_SRVS_INCLUDE_DIR)
  find_package(GTest REQUIRED)
  oroforge_add_bench(ros_service_bench SOURCES ros_service_bench.cpp ${folder}/service_fixture.cpp
    LIBS rtt_rostopic orocos-rtt oroforge_test_support GTest::gtest INCLUDES ${PROJECT_SOURCE_DIR}/tests ${folder}
    DEPENDS rtt-typekit rtt_rosservice rtt_rosservice_registry
    DEFINITIONS RTT_TYPEKIT_FILE="$<TARGET_FILE:rtt-typekit>" ROSSERVICE_FILE="$<TARGET_FILE:rtt_rosservice>"
      REGISTRY_FILE="$<TARGET_FILE:rtt_rosservice_registry>" SERVER_SCRIPT="${folder}/server.py")
endif()
