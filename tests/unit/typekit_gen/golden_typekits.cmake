# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Every golden typekit is compiled and loaded: those of tests/golden/typekit from the text that is kept there, those of
# tests/golden/typekit_view from what typegen makes of their headers during the build.
set(golden ${PROJECT_SOURCE_DIR}/tests/golden)
add_compile_options(${OROFORGE_ATTRIBUTE_OPTIONS})
file(GLOB text_cases CONFIGURE_DEPENDS LIST_DIRECTORIES true ${golden}/typekit/*)
file(GLOB view_cases CONFIGURE_DEPENDS LIST_DIRECTORIES true ${golden}/typekit_view/*)
# Sanitizers look at a few, which between them have every form of access: their compilers take longest over generated code.
if(OROFORGE_SANITIZE)
  list(FILTER text_cases INCLUDE REGEX "/(adapters|containers|enum_and_nested)$")
  set(view_cases "")
endif()

# A case may need headers of other projects, one path on each line of `needs`; without them it is left out, here and where
# it is run.
function(oroforge_golden_case_needs dir result)
  set(${result} "" PARENT_SCOPE)
  if(EXISTS ${dir}/needs)
    file(STRINGS ${dir}/needs paths)
    foreach(path ${paths})
      if(NOT EXISTS ${path})
        set(${result} ${path} PARENT_SCOPE)
      endif()
    endforeach()
  endif()
endfunction()

# Sources of a case that typegen makes of its headers.
function(oroforge_generate_golden_typekit dir output result)
  file(STRINGS ${dir}/args words ENCODING UTF-8)
  file(GLOB_RECURSE inputs CONFIGURE_DEPENDS ${dir}/*)
  set(files ${output}/Plugin.cpp)
  list(TRANSFORM words PREPEND ${dir}/ OUTPUT_VARIABLE listed)
  foreach(path ${listed})
    file(GLOB_RECURSE headers ${path}/*.hpp)
    if(path MATCHES "\\.(h|hpp)$")
      set(headers ${path})
    endif()
    foreach(header ${headers})
      get_filename_component(word ${header} NAME_WE)
      list(APPEND files ${output}/types_${word}.cpp)
    endforeach()
  endforeach()
  add_custom_command(OUTPUT ${files}
    COMMAND typegen -o ${output} ${words} WORKING_DIRECTORY ${dir} DEPENDS ${inputs} VERBATIM
    COMMENT "Generating ${output}")
  set(${result} ${files} PARENT_SCOPE)
endfunction()

# oroforge_add_golden_typekit(<target> <folder of the case> <folder of the generated files> <source>…)
# The sources are one translation unit, as separate ones would take minutes. There are two exceptions: where the case has
# several headers, each file is to have those that it needs and no others; and Clang refuses what one file declares extern
# after another has made an instance of it.
function(oroforge_add_golden_typekit target dir generated)
  file(STRINGS ${dir}/args words ENCODING UTF-8)
  # A user of the typekit includes its header alone.
  set(user ${CMAKE_CURRENT_BINARY_DIR}/${target}_user.cpp)
  set(name ${words})
  list(FILTER name EXCLUDE REGEX "^-")
  list(GET name 0 name)
  file(CONFIGURE OUTPUT ${user} CONTENT "#include \"types/${name}/typekit/Types.hpp\"\n")
  add_library(${target} MODULE ${ARGN} ${user})
  target_include_directories(${target} PRIVATE ${dir} ${dir}/include ${generated})
  list(FIND words -isystem at)
  if(NOT at EQUAL -1)
    math(EXPR at "${at} + 1")
    list(GET words ${at} folder)
    target_include_directories(${target} SYSTEM PRIVATE ${folder})
  endif()
  if("-std=c++20" IN_LIST words)
    target_compile_features(${target} PRIVATE cxx_std_20)
  endif()
  target_compile_options(${target} PRIVATE -O0 -g0)  # each for one short run
  set(libraries "")
  if(EXISTS ${dir}/libraries)
    file(STRINGS ${dir}/libraries libraries)
  endif()
  target_link_libraries(${target} PRIVATE orocos-rtt ${libraries})
  set_target_properties(${target} PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests/lib)
  if(words MATCHES "(^|;)input\\.h" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  endif()
endfunction()

set(golden_typekits "")
set(golden_cases "")
foreach(dir ${text_cases} ${view_cases})
  cmake_path(GET dir FILENAME case)
  oroforge_golden_case_needs(${dir} missing)
  if(missing)
    message(STATUS "golden typekit ${case} is left out: no ${missing}")
    continue()
  endif()
  set(target golden_typekit_${case})
  if(dir IN_LIST view_cases)
    set(generated ${CMAKE_CURRENT_BINARY_DIR}/${target})
    oroforge_generate_golden_typekit(${dir} ${generated} sources)
  else()
    set(generated ${dir}/expected)
    file(GLOB sources CONFIGURE_DEPENDS ${generated}/*.cpp)
    if(NOT sources)
      message(FATAL_ERROR "${dir}/expected has no sources: run typegen -o expected in ${dir}")
    endif()
  endif()
  oroforge_add_golden_typekit(${target} ${dir} ${generated} ${sources})
  list(APPEND golden_typekits ${target})
  list(APPEND golden_cases ${case})
endforeach()
list(JOIN golden_cases " " golden_cases)

oroforge_add_test(golden_typekit_test
  SOURCES adapted_types_test.cpp encoded_values_test.cpp ../encoding/reference_cdr.cpp enum_names_test.cpp golden_typekit.cpp golden_typekit_test.cpp other_names_test.cpp queued_values_test.cpp typekit_values_test.cpp value_filler.cpp
  LABELS unit golden
  LIBS oroforge_typekit_gen oroforge_test_support orocos-rtt orocos-rtt-encoding rtt-scripting rtt-marshalling
  DEFINITIONS GOLDEN_TYPEKIT_DIR="${PROJECT_BINARY_DIR}/tests/lib" GOLDEN_TYPEKITS="${golden_cases}" RTT_TYPEKIT_FILE="$<TARGET_FILE:rtt-typekit>"
  DEPENDS rtt-typekit rtt-transport-mqueue ${golden_typekits})
if(TARGET orocos-rtt-corba)
  target_sources(golden_typekit_test PRIVATE any_values_test.cpp)
  target_link_libraries(golden_typekit_test PRIVATE orocos-rtt-corba)
endif()

# What others read of recordings of these types; ./dev judges installs those readers.
if(TARGET orocos-ocl-reporting-mcap)
  oroforge_add_test(mcap_judges_test
    SOURCES recorded_values_test.cpp shape_filler.cpp
    LABELS judges
    LIBS orocos-rtt orocos-rtt-encoding orocos-ocl-replay orocos-ocl-reporting-mcap oroforge_mcap oroforge_message_schema oroforge_test_support
    DEFINITIONS GOLDEN_TYPEKIT_DIR="${PROJECT_BINARY_DIR}/tests/lib" GOLDEN_TYPEKITS="${golden_cases}" RTT_TYPEKIT_FILE="$<TARGET_FILE:rtt-typekit>"
      JUDGES_DIR="${PROJECT_BINARY_DIR}/tests/judges" JUDGE="${PROJECT_SOURCE_DIR}/tests/judges/recording.mjs"
    DEPENDS rtt-typekit ${golden_typekits}
    ENVIRONMENT ORO_LOGLEVEL=0 ORO_LOGFILE=/dev/null)
  _oroforge_collect_test(unit mcap_judges_test)
  add_test(NAME mcap_all_values_test COMMAND mcap_judges_test --gtest_filter=AllValues.*)
  set_tests_properties(mcap_all_values_test PROPERTIES LABELS unit ENVIRONMENT "ORO_LOGLEVEL=0;ORO_LOGFILE=/dev/null")
endif()

# Together with the C++ types themselves, as a component uses them.
set(restricted ${golden}/typekit/restricted)
file(GLOB sources CONFIGURE_DEPENDS ${restricted}/expected/*.cpp)
oroforge_add_test(restricted_values_test
  SOURCES restricted_values_test.cpp ${sources} INCLUDES ${restricted} ${restricted}/expected
  LIBS orocos-rtt rtt-scripting
  DEFINITIONS RTT_TYPEKIT_FILE="$<TARGET_FILE:rtt-typekit>"
  DEPENDS rtt-typekit)
