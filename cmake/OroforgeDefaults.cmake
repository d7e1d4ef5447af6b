# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Compiler settings shared by everything built in this tree.
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE RelWithDebInfo CACHE STRING "" FORCE)
endif()

add_compile_options(-Wall -Wextra)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # STB_GNU_UNIQUE symbols would keep each plugin in memory for ever. Clang makes none.
  add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-fno-gnu-unique>)
else()
  # A precompiled header with a time stamp differs in each clone, so ccache would not find it.
  add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:SHELL:-Xclang -fno-pch-timestamp>")
endif()
# The options that disable warnings about attributes [[oro::…]]. GCC before 12 cannot do so for some attributes only.
set(OROFORGE_ATTRIBUTE_OPTIONS
  $<$<AND:$<COMPILE_LANG_AND_ID:CXX,GNU>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,12>>:-Wno-attributes=oro::>
  $<$<COMPILE_LANG_AND_ID:CXX,Clang,AppleClang>:-Wno-unknown-attributes>)

set(OROFORGE_SANITIZE "" CACHE STRING "address | thread | undefined, or a list joined by commas")
if(OROFORGE_SANITIZE)
  add_compile_options(-fsanitize=${OROFORGE_SANITIZE} -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${OROFORGE_SANITIZE})
  # Macros of GCC for what Clang 19 offers only as features.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    string(REGEX MATCH "address|thread" kind ${OROFORGE_SANITIZE})
    string(TOUPPER "__SANITIZE_${kind}__" macro)
    add_compile_definitions(${macro}=1)
  endif()
  # `vptr` needs run-time type information, which code that uses LLVM does not have; inline functions that it shares with other
  # code would need it, too. The runtime turns it on for itself.
  if(OROFORGE_SANITIZE MATCHES "undefined")
    add_compile_options(-fno-sanitize=vptr)
  endif()
endif()
# oroforge_precompile(<target> <header>…): precompiles these headers, and usual ones of the standard library, which halves the
# compile time at -O0. Only in sanitizer builds, so that the ordinary build shows sources that do not include what they use.
function(oroforge_precompile target)
  if(OROFORGE_SANITIZE)
    target_precompile_headers(${target} PRIVATE <algorithm> <functional> <iostream> <map> <memory> <sstream> <string> <thread>
      <vector> ${ARGN})
  endif()
endfunction()
# Relocations of a library that only add its address take a tenth of the space, if the C library knows that form.
include(CheckCXXSourceRuns)
set(CMAKE_REQUIRED_LINK_OPTIONS -pie -Wl,-z,pack-relative-relocs)
check_cxx_source_runs("int main() { return 0; }" OROFORGE_PACKS_RELOCATIONS)
unset(CMAKE_REQUIRED_LINK_OPTIONS)
# oroforge_bind_symbols(): binds what the libraries of this directory and below use of themselves, which nobody replaces. Calls
# need no jump through a table (a tenth of the time of a sample that wakes a component), and a program starts in two thirds of
# the time. Types are compared by name, so several libraries may have the same one.
#
# A program that reads a variable of a library gets a copy of it, which the library must use, too. Such a library needs
# oroforge_share_variables(<target> <file>), with a list of these variables for the linker.
function(oroforge_bind_symbols)
  add_compile_options(-fno-semantic-interposition $<$<COMPILE_LANGUAGE:CXX>:-fvisibility-inlines-hidden>)
  add_link_options(-Wl,-Bsymbolic $<$<BOOL:${OROFORGE_PACKS_RELOCATIONS}>:-Wl,-z,pack-relative-relocs>)
endfunction()
function(oroforge_share_variables target file)
  get_filename_component(file ${file} ABSOLUTE)
  target_link_options(${target} PRIVATE -Wl,-Bno-symbolic,--dynamic-list=${file})
  set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${file})
endfunction()
# oroforge_unit(<target> <unit> <include folder> <file>…): compiles files of one subject as one translation unit, in which they
# share the unnamed namespace. Their names are relative to the include folder. UNITY_BUILD would not do: its files have the path
# of the clone, so other clones would not find them in ccache.
option(OROFORGE_UNITS_BY_SUBJECT "Compile all files of one subject as one, where that is faster" ON)
function(oroforge_unit target unit folder)
  list(TRANSFORM ARGN PREPEND ${folder}/ OUTPUT_VARIABLE sources)
  if(OROFORGE_UNITS_BY_SUBJECT)
    set_source_files_properties(${sources} PROPERTIES HEADER_FILE_ONLY TRUE)
    list(TRANSFORM ARGN REPLACE "(.+)" "#include <\\1>\n" OUTPUT_VARIABLE lines)
    list(JOIN lines "" text)
    set(made ${CMAKE_CURRENT_BINARY_DIR}/${unit}.cpp)
    file(CONFIGURE OUTPUT ${made} CONTENT "${text}" @ONLY)
    list(APPEND sources ${made})
  endif()
  target_sources(${target} PRIVATE ${sources})
endfunction()
# Clang links its sanitizers to programs, so that libraries find them when they are loaded.
if(NOT OROFORGE_SANITIZE OR CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_link_options(-Wl,-z,defs)
endif()

# Build tree and install tree have the same layout, so that programs run from both.
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/archive)
set(OROFORGE_PLUGIN_DIR lib/orocos/${OROCOS_TARGET})
