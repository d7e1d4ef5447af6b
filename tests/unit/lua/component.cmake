# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Components whose hooks are Lua functions: life cycle, threads, memory, deployment.
set(lua_library orocos-ocl-lua orocos-ocl-lua-tlsf ocl-rttlua-plugin-service ocl-rttlua-tlsf-plugin-service)
set(lua_definitions OCL_TEST_PATH="${PROJECT_BINARY_DIR}/lib/orocos")

oroforge_add_test(lua_component_test
  SOURCES lua_component_test.cpp lua_fault_test.cpp lua_memory_test.cpp
  LIBS orocos-ocl-lua orocos-ocl-lua-tlsf orocos-ocl-helloworld orocos-ocl-deployment oroforge_test_support
  INCLUDES ${PROJECT_SOURCE_DIR}/tests/unit
  DEFINITIONS ${lua_definitions} DEPENDS ${lua_library} rtt-typekit rtt-scripting)

oroforge_add_test(lua_thread_test LABELS unit concurrent
  SOURCES lua_thread_test.cpp
  LIBS orocos-ocl-lua orocos-ocl-helloworld orocos-ocl-deployment oroforge_test_support
  INCLUDES ${PROJECT_SOURCE_DIR}/tests/unit
  DEFINITIONS ${lua_definitions} DEPENDS ${lua_library} rtt-typekit rtt-scripting
  ENVIRONMENT ORO_LOGLEVEL=0 ORO_LOGFILE=/dev/null)

oroforge_add_test(lua_real_time_test
  SOURCES lua_real_time_test.cpp
  LIBS orocos-ocl-lua-tlsf orocos-ocl-lua orocos-ocl-deployment oroforge_test_support oroforge_real_time_trap
  INCLUDES ${PROJECT_SOURCE_DIR}/tests/unit
  DEFINITIONS ${lua_definitions} DEPENDS ${lua_library} rtt-typekit rtt-scripting
  ENVIRONMENT ORO_LOGLEVEL=0 ORO_LOGFILE=/dev/null)

oroforge_add_test(lua_deployer_test
  SOURCES lua_deployer_test.cpp
  LIBS oroforge_test_support
  INCLUDES ${PROJECT_SOURCE_DIR}/tests/unit
  DEFINITIONS DEPLOYER_PROGRAM="$<TARGET_FILE:deployer>" RTTSCRIPT_PROGRAM="$<TARGET_FILE:rttscript>"
    DEPLOYER_TEST_PATH="${PROJECT_BINARY_DIR}/lib/orocos"
  DEPENDS deployer rttscript ${lua_library} orocos-ocl-helloworld rtt-typekit rtt-marshalling rtt-scripting)
# Sanitizers stand in front of malloc() themselves: their builds have no --rt-check.
if(NOT OROFORGE_SANITIZE)
  target_compile_definitions(lua_deployer_test PRIVATE WITH_RT_CHECK)
endif()
