# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# The library `common`, with chains of components, and the package `fbsched`, their old name.
oroforge_component_library(common
  chain/Chain.cpp
  chain/cycles.cpp
  chain/data_flow.cpp
  chain/housekeeper.cpp
  chain/lifecycle.cpp
  chain/maintain.cpp
  chain/peers.cpp
  chain/report.cpp
  chain/roster.cpp
  chain/settings.cpp
  chain/times.cpp
  chain/triggers.cpp
  chain/types.cpp
  components/common.cpp
  components/HMIConsoleOutput.cpp)
# The type repository keeps the types of chains, which are code of this library.
target_link_options(orocos-ocl-common PRIVATE -Wl,-z,nodelete)
target_link_libraries(orocos-ocl-common PRIVATE $<BUILD_INTERFACE:oroforge_diag>)
oroforge_precompile(orocos-ocl-common <rtt/TaskContext.hpp>)

set(folder ${PROJECT_BINARY_DIR}/${OROFORGE_PLUGIN_DIR}/fbsched)
add_custom_command(TARGET orocos-ocl-common POST_BUILD
  COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
  COMMAND ${CMAKE_COMMAND} -E create_symlink ../ocl/$<TARGET_FILE_NAME:orocos-ocl-common>
          ${folder}/$<TARGET_FILE_NAME:orocos-ocl-common>
  VERBATIM)
install(FILES ${folder}/liborocos-ocl-common-${OROCOS_TARGET}.so DESTINATION ${OROFORGE_PLUGIN_DIR}/fbsched COMPONENT runtime)
