# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# The same two components, each time built with another version of one header and what typegen makes of it.
set(fingerprint_dir ${PROJECT_BINARY_DIR}/tests/fingerprint)
set(fingerprint_libraries "")

function(fingerprint_library version)
  set(name fingerprint_${version})
  string(TOUPPER ${version} macro)
  set(sources ${CMAKE_CURRENT_SOURCE_DIR}/fingerprint/components.cpp)
  if(NOT "UNDESCRIBED" IN_LIST ARGN)
    set(generated ${CMAKE_CURRENT_BINARY_DIR}/${name})
    add_custom_command(OUTPUT ${generated}/types_sample.cpp
      COMMAND typegen -DVERSION_${macro} -o ${generated} sample ${CMAKE_CURRENT_SOURCE_DIR}/fingerprint/sample.hpp
      DEPENDS typegen ${CMAKE_CURRENT_SOURCE_DIR}/fingerprint/sample.hpp VERBATIM)
    list(APPEND sources ${generated}/types_sample.cpp)
  endif()
  add_library(${name} MODULE ${sources})
  target_compile_definitions(${name} PRIVATE RTT_COMPONENT VERSION_${macro} ${ARGN}
    WRITER=Writer_${version} READER=Reader_${version})
  target_compile_options(${name} PRIVATE -O0 -g0)  # each for one short run
  target_include_directories(${name} PRIVATE ${generated}/types ${CMAKE_CURRENT_SOURCE_DIR}/fingerprint)
  target_link_libraries(${name} PRIVATE orocos-rtt)
  # Clang refuses what one file declares extern after another has made an instance of it.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  endif()
  set_target_properties(${name} PROPERTIES
    OUTPUT_NAME ${name}-${OROCOS_TARGET} LIBRARY_OUTPUT_DIRECTORY ${fingerprint_dir})
  set(fingerprint_libraries ${fingerprint_libraries} ${name} PARENT_SCOPE)
endfunction()

foreach(version first same swapped renamed retyped renumbered more_modes units)
  fingerprint_library(${version})
endforeach()
fingerprint_library(larger UNDESCRIBED)
fingerprint_library(plain UNDESCRIBED)

oroforge_add_test(fingerprint_test
  SOURCES fingerprint_test.cpp schema_test.cpp log_capture.cpp
  LIBS orocos-rtt
  DEFINITIONS FINGERPRINT_DIR="${fingerprint_dir}" FINGERPRINT_TARGET="${OROCOS_TARGET}"
  DEPENDS ${fingerprint_libraries})

oroforge_add_script_test(fingerprint.deployer_check
  COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/fingerprint/deployer_check.sh $<TARGET_FILE:deployer> ${fingerprint_dir}
    ${OROCOS_TARGET}
  DEPENDS deployer ${fingerprint_libraries})
