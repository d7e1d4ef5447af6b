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
  # STB_GNU_UNIQUE symbols would pin every plugin in memory for ever. Clang makes none.
  add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-fno-gnu-unique>)
else()
  # A precompiled header that holds the time of its making is another one in every clone, so ccache would find nothing.
  add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:SHELL:-Xclang -fno-pch-timestamp>")
endif()
# What makes a compiler silent about attributes [[oro::…]]. GCC before 12 cannot tell them from others.
set(OROFORGE_ATTRIBUTE_OPTIONS
  $<$<AND:$<COMPILE_LANG_AND_ID:CXX,GNU>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,12>>:-Wno-attributes=oro::>
  $<$<COMPILE_LANG_AND_ID:CXX,Clang,AppleClang>:-Wno-unknown-attributes>)

set(OROFORGE_SANITIZE "" CACHE STRING "address | thread | undefined, or a list joined by commas")
if(OROFORGE_SANITIZE)
  add_compile_options(-fsanitize=${OROFORGE_SANITIZE} -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${OROFORGE_SANITIZE})
  # GCC's names for what Clang 19 offers as features only.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    string(REGEX MATCH "address|thread" kind ${OROFORGE_SANITIZE})
    string(TOUPPER "__SANITIZE_${kind}__" macro)
    add_compile_definitions(${macro}=1)
  endif()
  # `vptr` asks for the dynamic type, which classes compiled without run-time type information, as LLVM's users are, do not
  # tell; the inline functions that they share with others would ask all the same. The runtime turns it on for itself.
  if(OROFORGE_SANITIZE MATCHES "undefined")
    add_compile_options(-fno-sanitize=vptr)
  endif()
endif()
# oroforge_precompile(<target>): the headers of the runtime, once for all sources, which halves what the compiler does at -O0.
# In sanitizer builds only: the ordinary build shows which source does not include what it uses.
function(oroforge_precompile target)
  if(OROFORGE_SANITIZE)
    target_precompile_headers(${target} PRIVATE <algorithm> <iostream> <sstream> <thread> <rtt/TaskContext.hpp>)
  endif()
endfunction()
# Clang links its sanitizers to programs, where the libraries find them when they are loaded.
if(NOT OROFORGE_SANITIZE OR CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_link_options(-Wl,-z,defs)
endif()

# One layout for the build tree and the install tree, so that programs run from either.
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/archive)
set(OROFORGE_PLUGIN_DIR lib/orocos/${OROCOS_TARGET})
