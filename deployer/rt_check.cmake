# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# What --rt-check puts in front of libc's functions. Sanitizers stand there themselves: their builds are without.
if(OROFORGE_SANITIZE)
  return()
endif()
find_package(Threads REQUIRED)
add_library(orocos-rtcheck SHARED
  rt_check/clocks.c
  rt_check/findings.cpp
  rt_check/locks.c
  rt_check/lookups.c
  rt_check/memory.c
  rt_check/next.c
  rt_check/outside.c
  rt_check/raw_calls.c
  rt_check/streams.c
  rt_check/symbols.cpp
  rt_check/system_calls.c
  rt_check/watch.cpp)
target_compile_definitions(orocos-rtcheck PRIVATE _GNU_SOURCE)
# The compiler must not take our functions for the ones it knows.
target_compile_options(orocos-rtcheck PRIVATE -U_FORTIFY_SOURCE $<$<COMPILE_LANGUAGE:C>:-fno-builtin>)
target_link_options(orocos-rtcheck PRIVATE -Wl,--version-script=${CMAKE_CURRENT_SOURCE_DIR}/rt_check/exports.map)
target_link_libraries(orocos-rtcheck PRIVATE Threads::Threads rt ${CMAKE_DL_LIBS})
set_target_properties(orocos-rtcheck PROPERTIES
  OUTPUT_NAME orocos-rtcheck-${OROCOS_TARGET} LIBRARY_OUTPUT_DIRECTORY ${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/oroforge
  C_VISIBILITY_PRESET hidden CXX_VISIBILITY_PRESET hidden
  LINK_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/rt_check/exports.map)
# Nobody links it, nor imports it: its folder is that of no package. The programs look for it from the runtime's library.
install(TARGETS orocos-rtcheck LIBRARY DESTINATION lib/oroforge COMPONENT runtime)
foreach(program deployer rttscript rttlua)
  if(TARGET ${program})
    add_dependencies(${program} orocos-rtcheck)
  endif()
endforeach()
