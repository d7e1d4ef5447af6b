# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# What a running deployment can be asked, for the module that serves clients.
find_package(nlohmann_json REQUIRED)
add_library(oroforge_live_requests OBJECT
  live/requests/call.cpp
  live/requests/component_thread.cpp
  live/requests/consoles.cpp
  live/requests/cycles.cpp
  live/requests/describe.cpp
  live/requests/fields.cpp
  live/requests/found_value.cpp
  live/requests/graph.cpp
  live/requests/interface_json.cpp
  live/requests/lifecycle.cpp
  live/requests/lines.cpp
  live/requests/lookup.cpp
  live/requests/permissions.cpp
  live/requests/ports.cpp
  live/requests/requests.cpp
  live/requests/set.cpp
  live/requests/show.cpp
  live/requests/ticket.cpp
  live/requests/top.cpp
  live/requests/value_syntax.cpp
  live/requests/values.cpp
  live/requests/workers.cpp)
target_include_directories(oroforge_live_requests PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(oroforge_live_requests
  PUBLIC orocos-rtt orocos-rtt-encoding orocos-ocl-taskbrowser rtt-scripting nlohmann_json::nlohmann_json oroforge_diag)
oroforge_precompile(oroforge_live_requests <nlohmann/json.hpp> <rtt/TaskContext.hpp>)
set_target_properties(oroforge_live_requests PROPERTIES POSITION_INDEPENDENT_CODE ON)
