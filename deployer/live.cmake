# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# The live window: a door in each deploying program, and the module with the server that it loads at the first client.
find_package(nlohmann_json REQUIRED)

target_sources(oroforge_deployer_program PRIVATE
  bin/live_window.cpp
  live/door/door.cpp
  live/door/peer.cpp
  live/door/socket_folder.cpp
  live/door/token.cpp
  live/door/unix_address.cpp
  live/door/web_address.cpp)

# Nobody imports or links it (live/door/module.hpp), but for tests.
add_library(orocos-ocl-live SHARED
  live/door/peer.cpp
  live/door/token.cpp
  live/samples/log_lines.cpp
  live/samples/port_watch.cpp
  live/server/access.cpp
  live/server/find_port.cpp
  live/server/foxglove_model.cpp
  live/server/foxglove_graph.cpp
  live/server/foxglove_service.cpp
  live/server/foxglove_session.cpp
  live/server/foxglove_text.cpp
  live/server/live_client.cpp
  live/server/message_queue.cpp
  live/server/module.cpp
  live/server/oro_messages.cpp
  live/server/oro_streams.cpp
  live/server/sample_batch.cpp
  live/server/server.cpp
  live/server/sockets.cpp
  live/server/text_depth.cpp
  live/server/transport.cpp)
target_include_directories(orocos-ocl-live PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(orocos-ocl-live
  PUBLIC orocos-rtt orocos-rtt-encoding nlohmann_json::nlohmann_json oroforge_live_requests)
oroforge_precompile(orocos-ocl-live <nlohmann/json.hpp> <rtt/TaskContext.hpp>)
set_target_properties(orocos-ocl-live PROPERTIES
  OUTPUT_NAME orocos-ocl-live-${OROCOS_TARGET}
  LIBRARY_OUTPUT_DIRECTORY ${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/oroforge
  BUILD_RPATH_USE_ORIGIN ON
  INSTALL_RPATH "$ORIGIN/..")
install(TARGETS orocos-ocl-live LIBRARY DESTINATION lib/oroforge COMPONENT runtime)
foreach(program deployer rttscript rttlua rttlua-tlsf rttlua-corba)
  if(TARGET ${program})
    add_dependencies(${program} orocos-ocl-live)
  endif()
endforeach()
