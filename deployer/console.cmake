# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# The console, and the library of OCL::TaskBrowser.
find_package(PkgConfig REQUIRED)
pkg_check_modules(EDIT REQUIRED IMPORTED_TARGET libedit)

add_library(orocos-ocl-taskbrowser SHARED
  console/TaskBrowser.cpp
  console/commands.cpp
  console/completion.cpp
  console/console.cpp
  console/cursor_row.cpp
  console/dot_commands.cpp
  console/help_text.cpp
  console/history.cpp
  console/interface_text.cpp
  console/interrupts.cpp
  console/kept_terminal.cpp
  console/known_ports.cpp
  console/libedit_parts.cpp
  console/line_editor.cpp
  console/line_source.cpp
  console/listing.cpp
  console/output_above.cpp
  console/place.cpp
  console/port_probe.cpp
  console/port_table.cpp
  console/program_listing.cpp
  console/screen.cpp
  console/scripted.cpp
  console/table.cpp
  console/terminal_signals.cpp
  console/theme.cpp
  console/value_lines.cpp
  console/value_table.cpp
  console/value_text.cpp
  console/visits.cpp
  console/watch.cpp
  console/watch_commands.cpp)
target_include_directories(orocos-ocl-taskbrowser PUBLIC
  $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}>
  $<INSTALL_INTERFACE:include> $<INSTALL_INTERFACE:include/orocos>)
target_link_libraries(orocos-ocl-taskbrowser
  PUBLIC orocos-rtt
  PRIVATE rtt-scripting $<BUILD_INTERFACE:oroforge_diag> $<BUILD_INTERFACE:PkgConfig::EDIT>)
oroforge_precompile(orocos-ocl-taskbrowser <rtt/TaskContext.hpp>)
set_target_properties(orocos-ocl-taskbrowser PROPERTIES
  OUTPUT_NAME orocos-ocl-taskbrowser-${OROCOS_TARGET} VERSION ${PROJECT_VERSION}
  SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
  INSTALL_RPATH "$ORIGIN;$ORIGIN/orocos/${OROCOS_TARGET}/plugins")

add_library(oroforge_console_stay OBJECT bin/console_stay.cpp)
target_link_libraries(oroforge_console_stay PUBLIC oroforge_deployer_program orocos-ocl-taskbrowser)
target_link_libraries(deployer PRIVATE oroforge_console_stay orocos-ocl-taskbrowser)
