# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# The component library: what import("ocl") brings.

# oroforge_component_library(<name> <source>…) makes liborocos-ocl-<name>-<target>.so, a library of components.
function(oroforge_component_library name)
  set(target orocos-ocl-${name})
  add_library(${target} SHARED ${ARGN})
  target_compile_definitions(${target} PRIVATE RTT_COMPONENT)
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:include> $<INSTALL_INTERFACE:include/orocos>)
  target_link_libraries(${target} PUBLIC orocos-rtt)
  set_target_properties(${target} PROPERTIES
    OUTPUT_NAME ${target}-${OROCOS_TARGET}
    LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${OROFORGE_PLUGIN_DIR}/ocl
    BUILD_RPATH_USE_ORIGIN ON
    INSTALL_RPATH "$ORIGIN/../../..;$ORIGIN")
  set_property(GLOBAL APPEND PROPERTY OROFORGE_COMPONENT_LIBRARIES ${target})
endfunction()

# oroforge_ocl_service(<name> <source>…) makes the service plugin lib<name>-<target>.so.
function(oroforge_ocl_service name)
  set(target ocl-${name}-service)
  add_library(${target} MODULE ${ARGN})
  target_link_libraries(${target} PRIVATE orocos-rtt)
  set_target_properties(${target} PROPERTIES
    OUTPUT_NAME ${name}-${OROCOS_TARGET}
    LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${OROFORGE_PLUGIN_DIR}/ocl/plugins
    BUILD_RPATH_USE_ORIGIN ON
    INSTALL_RPATH "$ORIGIN/../../../..;$ORIGIN/..")
  set_property(GLOBAL APPEND PROPERTY OROFORGE_COMPONENT_SERVICES ${target})
endfunction()

include(chain.cmake)
oroforge_component_library(helloworld components/HelloWorld.cpp)
oroforge_component_library(timer components/TimerComponent.cpp)
oroforge_ocl_service(os components/os_service.cpp)
oroforge_ocl_service(print components/print_service.cpp)
