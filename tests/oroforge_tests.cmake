# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
#
# oroforge_add_test(<name>
#   SOURCES <file>…          test sources, relative to the fragment's folder
#   [LABELS <label>…]        unit (default), golden, build, slow; add `concurrent` for what TSan should run
#   [LIBS <target>…]         linked besides GoogleTest
#   [INCLUDES <dir>…] [DEFINITIONS <def>…] [DEPENDS <target>…]
#   [ENVIRONMENT <VAR=value>…]
#   [TIMEOUT <seconds>]      for each test case, default 60
#   [PREFIX <text>]          before each test name; default "<name>."
#   [NO_MAIN]                the sources bring their own main()
#   [AS_ONE]                 sources below tests/unit are compiled as one, because their headers take longer: they share the
#                            unnamed namespace
#   [OWN_HEADERS]            without a precompiled header: the test is about what includes bring
#   [SERIAL]                 never beside another test (timing, memory limits)
#   [TOGETHER]               all cases in one process, as one test: they share what is slow to start. Under sanitizers, where
#                            that takes longer than most cases, they do so anyway, but for those of ROS
#   [APART]                  not under sanitizers either
#   [SHARED <pattern>])      so do only the cases of this --gtest_filter, without exclusions
#
# oroforge_add_script_test(<name> COMMAND <word>… [LABELS …] [DEPENDS <target>…] [ENVIRONMENT …] [TIMEOUT s] [PARALLEL] [SERIAL])
#   a test that is a command; default label unit, default time limit 120 s. PARALLEL: it keeps two processors busy.
#
# oroforge_add_user_test(<name> COMMAND <word>… [LABELS <label>…] [TIMEOUT s] [PARALLEL])
#   a script that builds packages with the installed toolchain, <build>/tests/prefix; default label build, default time
#   limit 300 s. PARALLEL: it compiles with two processes. Packages are compiled as cheaply as their own files allow.
#
# Tests are not part of `all`: target `tests` builds every one of them, `tests-<label>` those with that label,
# each together with the plugins and libraries that its folder defines.
include_guard(GLOBAL)
include(GoogleTest)
find_package(GTest REQUIRED)

# PRE_TEST: the programs are asked for their cases when ctest starts, so a sanitizer build or a
# missing plugin cannot break the build itself.
set(CMAKE_GTEST_DISCOVER_TESTS_DISCOVERY_MODE PRE_TEST)

# Collects what `tests` and `tests-<label>` build.
add_custom_target(tests)
function(_oroforge_collect_test labels)
  foreach(label ${labels})
    if(NOT TARGET tests-${label})
      add_custom_target(tests-${label})
      add_dependencies(tests tests-${label})
    endif()
    if(ARGN)
      add_dependencies(tests-${label} ${ARGN})
    endif()
  endforeach()
endfunction()

function(_oroforge_sources_as_one name)
  set(own "")
  foreach(source ${ARGN})
    get_filename_component(source ${source} ABSOLUTE)
    if(source MATCHES "^${PROJECT_SOURCE_DIR}/tests/(unit/.*)$")
      list(APPEND own ${CMAKE_MATCH_1})
    else()
      target_sources(${name} PRIVATE ${source})
    endif()
  endforeach()
  oroforge_unit(${name} ${name}_unit ${PROJECT_SOURCE_DIR}/tests ${own})
  # What GCC says of unnamed namespaces in files that are included.
  target_compile_options(${name} PRIVATE $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-subobject-linkage>)
endfunction()

function(oroforge_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "NO_MAIN;AS_ONE;OWN_HEADERS;SERIAL;TOGETHER;APART" "TIMEOUT;PREFIX;SHARED"
    "SOURCES;LABELS;LIBS;INCLUDES;DEFINITIONS;DEPENDS;ENVIRONMENT")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "oroforge_add_test(${name}): unknown arguments: ${arg_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT arg_SOURCES)
    message(FATAL_ERROR "oroforge_add_test(${name}): no SOURCES")
  endif()
  if(NOT arg_LABELS)
    set(arg_LABELS unit)
  endif()
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 60)
  endif()
  if(NOT DEFINED arg_PREFIX)
    set(arg_PREFIX "${name}.")
  endif()
  if(arg_AS_ONE)
    add_executable(${name})
    _oroforge_sources_as_one(${name} ${arg_SOURCES})
  else()
    add_executable(${name} ${arg_SOURCES})
  endif()
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests/bin)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests ${arg_INCLUDES})
  target_compile_definitions(${name} PRIVATE ${arg_DEFINITIONS})
  if(arg_NO_MAIN)
    target_link_libraries(${name} PRIVATE ${arg_LIBS} GTest::gmock GTest::gtest)
  else()
    target_link_libraries(${name} PRIVATE ${arg_LIBS} GTest::gmock GTest::gtest GTest::gtest_main)
  endif()
  string(REGEX MATCH "(^|;)(rtt_|PkgConfig::ROSCPP)" uses_ros "${arg_LIBS}")
  if(NOT arg_OWN_HEADERS)
    set(headers plain)
    if(uses_ros AND TARGET oroforge_test_headers_ros)
      set(headers ros)
    elseif("${arg_LIBS}" MATCHES "(^|;)(orocos|rtt)-")
      set(headers runtime)
    endif()
    target_precompile_headers(${name} REUSE_FROM oroforge_test_headers_${headers})
    # Sources of the toolchain that a test takes are compiled as they are elsewhere.
    set(others ${arg_SOURCES})
    list(FILTER others INCLUDE REGEX "^${PROJECT_SOURCE_DIR}/(runtime|deployer|generator|typekit_gen)/")
    set_source_files_properties(${others} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
  endif()
  if(arg_DEPENDS)
    add_dependencies(${name} ${arg_DEPENDS})
  endif()
  set_property(GLOBAL APPEND PROPERTY OROFORGE_TEST_PROGRAMS ${name})
  _oroforge_collect_test("${arg_LABELS}" ${name})
  # A process is one node of ROS, which cannot begin again.
  if(OROFORGE_SANITIZE AND NOT uses_ros AND NOT arg_APART)
    set(arg_TOGETHER TRUE)
    set(arg_SHARED "")
    # That of a case times ten.
    string(APPEND arg_TIMEOUT 0)
  endif()
  if(arg_TOGETHER OR arg_SHARED)
    set(others "")
    if(arg_SHARED)
      add_test(NAME ${name} COMMAND ${name} --gtest_filter=${arg_SHARED})
      set(others TEST_FILTER "-${arg_SHARED}")
    else()
      add_test(NAME ${name} COMMAND ${name})
    endif()
    set_tests_properties(${name} PROPERTIES TIMEOUT ${arg_TIMEOUT} RUN_SERIAL ${arg_SERIAL} LABELS "${arg_LABELS}"
      ENVIRONMENT "${arg_ENVIRONMENT}")
    if(arg_TOGETHER)
      return()
    endif()
  endif()
  gtest_discover_tests(${name} ${others} TEST_PREFIX "${arg_PREFIX}" DISCOVERY_TIMEOUT 60
    PROPERTIES TIMEOUT ${arg_TIMEOUT} RUN_SERIAL ${arg_SERIAL})
  # gtest_discover_tests breaks lists apart, so what is a list is set when ctest has read the cases.
  set(extra ${CMAKE_CURRENT_BINARY_DIR}/${name}_properties.cmake)
  file(CONFIGURE OUTPUT ${extra} @ONLY CONTENT [=[
if(@name@_TESTS)
  set_tests_properties(${@name@_TESTS} PROPERTIES LABELS "@arg_LABELS@" ENVIRONMENT "@arg_ENVIRONMENT@")
endif()
]=])
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${extra})
endfunction()

function(oroforge_add_script_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "PARALLEL;SERIAL" "TIMEOUT" "COMMAND;LABELS;ENVIRONMENT;DEPENDS")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "oroforge_add_script_test(${name}): unknown arguments: ${arg_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT arg_LABELS)
    set(arg_LABELS unit)
  endif()
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 120)
  endif()
  _oroforge_collect_test("${arg_LABELS}" ${arg_DEPENDS})
  add_test(NAME ${name} COMMAND ${arg_COMMAND})
  set_tests_properties(${name} PROPERTIES LABELS "${arg_LABELS}" TIMEOUT ${arg_TIMEOUT}
    ENVIRONMENT "${arg_ENVIRONMENT}")
  if(arg_PARALLEL)
    set_tests_properties(${name} PROPERTIES PROCESSORS 2)
  endif()
  if(arg_SERIAL)
    set_tests_properties(${name} PROPERTIES RUN_SERIAL TRUE)
  endif()
endfunction()

function(oroforge_add_user_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "PARALLEL" "TIMEOUT" "COMMAND;LABELS")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "oroforge_add_user_test(${name}): unknown arguments: ${arg_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT arg_LABELS)
    set(arg_LABELS build)
  endif()
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 300)
  endif()
  # ccache knows a package again only if its folder and the toolchain lie in the same way below CCACHE_BASEDIR (./dev).
  set(folder ${PROJECT_BINARY_DIR}/tests/tmp)
  file(MAKE_DIRECTORY ${folder})
  # Else CMake does not install what was built again within a second, which ccache makes possible.
  set(environment TMPDIR=${folder} CMAKE_GENERATOR=Ninja CMAKE_BUILD_TYPE=Debug CMAKE_INSTALL_ALWAYS=1)
  if(CMAKE_CXX_COMPILER_LAUNCHER)
    list(APPEND environment CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER})
  endif()
  add_test(NAME ${name} COMMAND ${arg_COMMAND} WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
  set_tests_properties(${name} PROPERTIES FIXTURES_REQUIRED toolchain LABELS "${arg_LABELS}" TIMEOUT ${arg_TIMEOUT}
    ENVIRONMENT "${environment}")
  if(arg_PARALLEL)
    set_tests_properties(${name} PROPERTIES PROCESSORS 2)
  endif()
endfunction()
