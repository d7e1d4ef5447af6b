# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Recordings: files that robotics viewers open. Left out if there is no library that compresses them.
find_package(PkgConfig REQUIRED)
pkg_check_modules(ZSTD IMPORTED_TARGET libzstd)
pkg_check_modules(LZ4 IMPORTED_TARGET liblz4)
if(NOT ZSTD_FOUND AND NOT LZ4_FOUND)
  message(STATUS "neither zstd (libzstd-dev) nor lz4 (liblz4-dev) is installed: no recordings (MCAP files)")
  return()
endif()

add_library(oroforge_mcap STATIC
  reporting/mcap/chunk.cpp
  reporting/mcap/compression.cpp
  reporting/mcap/contents.cpp
  reporting/mcap/crc32.cpp
  reporting/mcap/in_order.cpp
  reporting/mcap/pieces.cpp
  reporting/mcap/records.cpp
  reporting/mcap/salvage.cpp
  reporting/mcap/scan.cpp
  reporting/mcap/source.cpp
  reporting/mcap/summary.cpp
  reporting/mcap/writer.cpp)
target_include_directories(oroforge_mcap PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
set_target_properties(oroforge_mcap PROPERTIES POSITION_INDEPENDENT_CODE ON)
foreach(library ZSTD LZ4)
  string(TOLOWER ${library} name)
  if(${library}_FOUND)
    target_link_libraries(oroforge_mcap PRIVATE PkgConfig::${library})
    target_compile_definitions(oroforge_mcap PRIVATE OROFORGE_MCAP_${library})
  else()
    message(STATUS "${name} (lib${name}-dev) is not installed: recordings cannot be compressed by it")
  endif()
endforeach()

# What the messages of a recording consist of.
add_library(oroforge_message_schema STATIC
  reporting/schema/detail/idl_number.cpp
  reporting/schema/detail/idl_parser.cpp
  reporting/schema/detail/idl_reader.cpp
  reporting/schema/detail/idl_text.cpp
  reporting/schema/detail/idl_tokens.cpp
  reporting/schema/detail/idl_types.cpp
  reporting/schema/detail/ros_text.cpp
  reporting/schema/message_schema.cpp
  reporting/schema/message_walk.cpp)
target_include_directories(oroforge_message_schema PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
set_target_properties(oroforge_message_schema PROPERTIES POSITION_INDEPENDENT_CODE ON)

# Recordings, for programs with and without the runtime.
add_library(oroforge_mcap_file STATIC
  reporting/mcap_file/about.cpp
  reporting/mcap_file/packages.cpp
  reporting/mcap_file/log_message.cpp
  reporting/mcap_file/record_file.cpp
  reporting/mcap_file/split.cpp
  reporting/report_file.cpp)
target_include_directories(oroforge_mcap_file PRIVATE ${PROJECT_SOURCE_DIR}/runtime)
target_link_libraries(oroforge_mcap_file PUBLIC oroforge_mcap)
set_target_properties(oroforge_mcap_file PROPERTIES POSITION_INDEPENDENT_CODE ON)

oroforge_component_library(reporting-mcap
  reporting/recording/McapReporting.cpp
  reporting/recording/about.cpp
  reporting/recording/chunk_pipe.cpp
  reporting/recording/chunk_takers.cpp
  reporting/recording/components.cpp
  reporting/recording/log_channel.cpp
  reporting/recording/options.cpp
  reporting/recording/recorded_source.cpp
  reporting/recording/recording.cpp
  reporting/recording/state_channel.cpp)
target_link_libraries(orocos-ocl-reporting-mcap
  PUBLIC orocos-ocl-reporting
  PRIVATE orocos-rtt-encoding $<BUILD_INTERFACE:oroforge_mcap_file> $<BUILD_INTERFACE:oroforge_diag>)
oroforge_precompile(orocos-ocl-reporting-mcap <rtt/TaskContext.hpp>)
target_compile_definitions(orocos-ocl-reporting-mcap PRIVATE OROFORGE_VERSION="${PROJECT_VERSION}")

# What repeats them. A deployer loads it when it is needed (replay/player.hpp).
oroforge_component_library(replay
  replay/component/McapReplay.cpp
  replay/component/components.cpp
  replay/component/replay_options.cpp
  replay/component/replay_ports.cpp
  replay/player/message_decoder.cpp
  replay/player/module.cpp
  replay/player/recorded_channel.cpp
  replay/player/recording_player.cpp
  replay/player/repeated_port.cpp
  replay/player/transcoder.cpp
  replay/player/type_difference.cpp)
target_link_libraries(orocos-ocl-replay
  PRIVATE orocos-rtt-encoding $<BUILD_INTERFACE:oroforge_mcap> $<BUILD_INTERFACE:oroforge_message_schema>
    $<BUILD_INTERFACE:oroforge_diag>)
oroforge_precompile(orocos-ocl-replay <rtt/TaskContext.hpp>)

# The program that reads recordings.
find_package(CLI11 QUIET)
if(NOT CLI11_FOUND)
  message(STATUS "CLI11 (libcli11-dev) is not installed: no program oro-mcap, which reads recordings")
  return()
endif()
add_executable(oro-mcap
  reporting/mcap_tool/cat.cpp
  reporting/mcap_tool/convert.cpp
  reporting/mcap_tool/convert_netcdf.cpp
  reporting/mcap_tool/convert_table.cpp
  reporting/mcap_tool/diff.cpp
  reporting/mcap_tool/info.cpp
  reporting/mcap_tool/leaves.cpp
  reporting/mcap_tool/main.cpp
  reporting/mcap_tool/netcdf_writer.cpp
  reporting/mcap_tool/new_file.cpp
  reporting/mcap_tool/opened_file.cpp
  reporting/mcap_tool/options.cpp
  reporting/mcap_tool/plain_text.cpp
  reporting/mcap_tool/recover.cpp)
target_link_libraries(oro-mcap PRIVATE oroforge_mcap oroforge_message_schema oroforge_diag CLI11::CLI11)
install(TARGETS oro-mcap RUNTIME DESTINATION bin COMPONENT runtime)
