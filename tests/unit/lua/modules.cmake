# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Sanitizers keep memory that was given back.
set(sanitized 0)
if(OROFORGE_SANITIZE)
  set(sanitized 1)
endif()

# The module `rtt` and the Lua modules: each file in scripts/ is a test that the deployer's service Lua executes.
oroforge_add_test(lua_scripts_test
  SOURCES scripts_test.cpp
  LIBS orocos-ocl-deployment oroforge_test_support
  INCLUDES ${PROJECT_SOURCE_DIR}/tests/unit
  DEFINITIONS LUA_SCRIPTS="${CMAKE_CURRENT_SOURCE_DIR}/scripts" OCL_TEST_PATH="${PROJECT_BINARY_DIR}/lib/orocos"
    LUA_SANITIZED=${sanitized}
  TIMEOUT 180 ENVIRONMENT ORO_LOGFILE=/dev/null
  DEPENDS orocos-ocl-lua orocos-ocl-lua-tlsf ocl-rttlua-plugin-service ocl-rttlua-tlsf-plugin-service ocl-print-service
    orocos-ocl-helloworld lua-modules rtt-typekit rtt-scripting rtt-marshalling)
