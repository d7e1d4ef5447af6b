# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Logging by categories: the classes that real-time threads log to, and the components that write. Left out where log4cpp is
# not installed.
find_path(LOG4CPP_INCLUDE_DIR log4cpp/HierarchyMaintainer.hh)
find_library(LOG4CPP_LIBRARY log4cpp)
mark_as_advanced(LOG4CPP_INCLUDE_DIR LOG4CPP_LIBRARY)
if(NOT LOG4CPP_INCLUDE_DIR OR NOT LOG4CPP_LIBRARY)
  message(STATUS "log4cpp (liblog4cpp5-dev) is not installed: no logging by categories")
  return()
endif()

oroforge_component_library(logging
  logging/Appender.cpp
  logging/Category.cpp
  logging/CategoryStream.cpp
  logging/FileAppender.cpp
  logging/LoggingEvent.cpp
  logging/LoggingService.cpp
  logging/OstreamAppender.cpp
  logging/SyslogAppender.cpp
  logging/category_factory.cpp
  logging/category_name.cpp
  logging/components.cpp
  logging/dropped_events.cpp
  logging/event_pool.cpp
  logging/fd_lines.cpp
  logging/file_lines.cpp
  logging/layouts.cpp
  logging/line_appender.cpp
  logging/logging_setup.cpp
  logging/origin.cpp
  logging/priorities.cpp
  logging/runtime_log.cpp
  logging/syslog_lines.cpp)
# By its plain name, which installed CMake files can give to others.
target_link_libraries(orocos-ocl-logging PUBLIC log4cpp)
oroforge_precompile(orocos-ocl-logging <rtt/TaskContext.hpp>)
# log4cpp keeps objects of this library until the end of the process.
target_link_options(orocos-ocl-logging PRIVATE -Wl,-z,nodelete)

# The types of the component library.
add_library(ocl-typekit MODULE logging/typekit.cpp)
target_link_libraries(ocl-typekit PRIVATE orocos-rtt orocos-ocl-logging)
set_target_properties(ocl-typekit PROPERTIES
  OUTPUT_NAME ocl-${OROCOS_TARGET}
  LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${OROFORGE_PLUGIN_DIR}/ocl/types
  BUILD_RPATH_USE_ORIGIN ON
  INSTALL_RPATH "$ORIGIN/../../../..;$ORIGIN/..")

# The deployers let log4cpp make categories of this library.
target_compile_definitions(oroforge_deployer_program PRIVATE OROFORGE_WITH_LOG4CPP)
target_link_libraries(oroforge_deployer_program PUBLIC orocos-ocl-logging)
