# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# oro: looks at and commands running deployments. It does not link the runtime, so that it starts in milliseconds.
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)

find_package(Threads REQUIRED)
add_library(oroforge_live_client STATIC
  console/history.cpp
  console/libedit_parts.cpp
  console/table.cpp
  console/theme.cpp
  live/client/address.cpp
  live/client/canvas.cpp
  live/client/command_line.cpp
  live/client/commands.cpp
  live/client/completion.cpp
  live/client/connection.cpp
  live/client/console_command.cpp
  live/client/discovery.cpp
  live/client/echo_command.cpp
  live/client/follow.cpp
  live/client/graph_command.cpp
  live/client/interrupts.cpp
  live/client/json.cpp
  live/client/lifecycle_commands.cpp
  live/client/list_command.cpp
  live/client/log_command.cpp
  live/client/manual.cpp
  live/client/other_program.cpp
  live/client/output.cpp
  live/client/picture.cpp
  live/client/plot_command.cpp
  live/client/program.cpp
  live/client/prompt.cpp
  live/client/rate_commands.cpp
  live/client/requests.cpp
  live/client/session.cpp
  live/client/short_path.cpp
  live/client/show_command.cpp
  live/client/state_text.cpp
  live/client/statistics.cpp
  live/client/top_command.cpp
  live/client/tree_command.cpp
  live/client/value_commands.cpp
  live/client/value_text.cpp)
find_package(Threads REQUIRED)
target_include_directories(oroforge_live_client PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
target_compile_definitions(oroforge_live_client PRIVATE OROFORGE_VERSION="${PROJECT_VERSION}")
oroforge_precompile(oroforge_live_client <nlohmann/json.hpp>)
target_link_libraries(oroforge_live_client
  PUBLIC oroforge_diag nlohmann_json::nlohmann_json
  PRIVATE CLI11::CLI11 PkgConfig::EDIT Boost::headers Threads::Threads)

if(TARGET oroforge_mcap_file)
  target_sources(oroforge_live_client PRIVATE
    live/client/port_patterns.cpp
    live/client/record_command.cpp
    live/client/recorder.cpp)
  target_link_libraries(oroforge_live_client PRIVATE oroforge_mcap_file)
else()
  target_sources(oroforge_live_client PRIVATE live/client/no_recordings.cpp)
endif()

add_executable(oro bin/oro.cpp)
target_link_libraries(oro PRIVATE oroforge_live_client)
install(TARGETS oro RUNTIME DESTINATION bin COMPONENT runtime)

# Manual pages and completions are made of the table of commands, by the program itself.
set(pages ${CMAKE_CURRENT_BINARY_DIR}/oro)
find_program(GZIP_PROGRAM gzip)
set(compress COMMAND ${CMAKE_COMMAND} -E true)
if(GZIP_PROGRAM)
  set(compress COMMAND sh -c "${GZIP_PROGRAM} -9nf ${pages}/man/*.1")
endif()
add_custom_command(OUTPUT ${pages}/stamp
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${pages}/man
  COMMAND ${CMAKE_COMMAND} -E make_directory ${pages}/man
  COMMAND oro man --directory ${pages}/man
  ${compress}
  COMMAND oro completion bash > ${pages}/oro.bash
  COMMAND oro completion zsh > ${pages}/_oro
  COMMAND oro completion fish > ${pages}/oro.fish
  COMMAND ${CMAKE_COMMAND} -E touch ${pages}/stamp
  DEPENDS oro COMMENT "Manual pages and completions of oro" VERBATIM)
add_custom_target(oro_pages ALL DEPENDS ${pages}/stamp)
install(DIRECTORY ${pages}/man/ DESTINATION share/man/man1 COMPONENT runtime)
install(FILES ${pages}/oro.bash DESTINATION share/bash-completion/completions RENAME oro COMPONENT runtime)
install(FILES ${pages}/_oro DESTINATION share/zsh/vendor-completions COMPONENT runtime)
install(FILES ${pages}/oro.fish DESTINATION share/fish/vendor_completions.d COMPONENT runtime)
