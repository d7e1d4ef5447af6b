# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
if(TARGET orocos-ocl-live)
  find_package(nlohmann_json REQUIRED)
  set(door ${PROJECT_SOURCE_DIR}/deployer/live/door)
  oroforge_add_bench(live_bench SOURCES live_bench.cpp ${door}/door.cpp ${door}/socket_folder.cpp ${door}/unix_address.cpp
    ${door}/web_address.cpp
    LIBS orocos-ocl-live oroforge_test_support nlohmann_json::nlohmann_json
    INCLUDES ${PROJECT_SOURCE_DIR}/tests/unit ${PROJECT_SOURCE_DIR}/deployer
    DEFINITIONS RTT_TYPEKIT_FILE="$<TARGET_FILE:rtt-typekit>" DEPENDS rtt-typekit)
endif()
