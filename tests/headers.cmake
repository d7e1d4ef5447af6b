# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Nearly every test includes GoogleTest and the runtime, which take longer to parse than the test to compile; those of ROS
# include roscpp, too. They are compiled once, as precompiled headers. oroforge_add_test() gives a program the one that fits what it links.
set(standard <algorithm> <atomic> <chrono> <filesystem> <fstream> <functional> <iostream> <map> <memory> <mutex> <optional>
  <set> <sstream> <string> <thread> <vector> <gmock/gmock.h> <gtest/gtest.h>)

# Programs, not libraries: a precompiled header is compiled as position-independent as what uses it.
set(kinds plain runtime)
if(TARGET rtt_ros)
  list(APPEND kinds ros)
endif()
foreach(kind ${kinds})
  set(owner oroforge_test_headers_${kind})
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${owner}.cpp CONTENT "int main() {}\n")
  add_executable(${owner} EXCLUDE_FROM_ALL ${CMAKE_CURRENT_BINARY_DIR}/${owner}.cpp)
  target_link_libraries(${owner} PRIVATE GTest::gmock GTest::gtest)
endforeach()
target_precompile_headers(oroforge_test_headers_plain PRIVATE ${standard})
target_link_libraries(oroforge_test_headers_runtime PRIVATE orocos-rtt)
target_precompile_headers(oroforge_test_headers_runtime PRIVATE ${standard} <rtt/RTT.hpp>)
if(TARGET rtt_ros)
  target_link_libraries(oroforge_test_headers_ros PRIVATE rtt_ros)
  target_precompile_headers(oroforge_test_headers_ros PRIVATE ${standard} <rtt/RTT.hpp> <ros/ros.h> <support/ros_master.hpp>)
  target_include_directories(oroforge_test_headers_ros PRIVATE ${PROJECT_SOURCE_DIR}/tests)
endif()
