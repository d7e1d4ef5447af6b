# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Lua: the module `rtt`, components, services and programs. Left out where Lua 5.1 is not installed.
#
# Debian has the library compiled as C++, too: its errors are exceptions, so that destructors run.
pkg_check_modules(LUA IMPORTED_TARGET lua5.1-c++)
if(NOT LUA_FOUND)
  message(STATUS "Lua 5.1 (liblua5.1-0-dev) is not installed: no Lua components and programs")
  return()
endif()

oroforge_component_library(lua
  lua/LuaComponent.cpp
  lua/assign_table.cpp
  lua/bind_hook.cpp
  lua/bind_module.cpp
  lua/bind_operation.cpp
  lua/bind_port.cpp
  lua/bind_property.cpp
  lua/bind_requester.cpp
  lua/bind_service.cpp
  lua/bind_task.cpp
  lua/bind_variable.cpp
  lua/box.cpp
  lua/complete.cpp
  lua/complete_names.cpp
  lua/conversion.cpp
  lua/describe_operation.cpp
  lua/failure.cpp
  lua/interpreter.cpp
  lua/life.cpp
  lua/member_access.cpp
  lua/memory.cpp
  lua/operation_call.cpp
  lua/operation_lookup.cpp
  lua/owned_things.cpp
  lua/pool_functions.cpp
  lua/provided_call.cpp
  lua/provided_operation.cpp
  lua/read_signature.cpp
  lua/script.cpp
  lua/search_paths.cpp
  lua/state.cpp
  lua/state_calls.cpp
  lua/values.cpp)
target_link_libraries(orocos-ocl-lua PRIVATE $<BUILD_INTERFACE:PkgConfig::LUA>)
oroforge_precompile(orocos-ocl-lua <rtt/TaskContext.hpp>)

oroforge_component_library(lua-tlsf lua/LuaTLSFComponent.cpp)
target_link_libraries(orocos-ocl-lua-tlsf PRIVATE orocos-ocl-lua $<BUILD_INTERFACE:PkgConfig::LUA>)
oroforge_ocl_service(rttlua-plugin lua/lua_service.cpp)
oroforge_ocl_service(rttlua-tlsf-plugin lua/lua_tlsf_service.cpp)
foreach(service rttlua-plugin rttlua-tlsf-plugin)
  target_link_libraries(ocl-${service}-service PRIVATE orocos-ocl-lua $<BUILD_INTERFACE:PkgConfig::LUA>)
endforeach()

# The programs.
add_library(oroforge_lua_program OBJECT bin/lua_command_line.cpp bin/lua_program.cpp bin/lua_prompt.cpp bin/lua_session.cpp)
target_link_libraries(oroforge_lua_program
  PUBLIC orocos-ocl-lua orocos-ocl-deployment orocos-ocl-taskbrowser PkgConfig::LUA)
set(programs rttlua rttlua-tlsf)
if(TARGET orocos-ocl-deployment-corba)
  list(APPEND programs rttlua-corba)
endif()
foreach(program ${programs})
  string(REPLACE - _ source ${program})
  oroforge_target_program(${program} bin/${source}.cpp)
  target_link_libraries(${program} PRIVATE oroforge_lua_program oroforge_deployer_program orocos-ocl-lua)
endforeach()
target_link_libraries(rttlua-tlsf PRIVATE orocos-ocl-lua-tlsf)
if(TARGET rttlua-corba)
  target_link_libraries(rttlua-corba PRIVATE oroforge_corba_program)
endif()

# The Lua modules, where an installed library and one of this build look for them (lua/search_paths.cpp).
set(modules
  ansicolors.lua
  rfsm_rtt.lua
  rttlib.lua
  rttlib/components.lua
  rttlib/describe.lua
  rttlib/documented.lua
  rttlib/extend.lua
  rttlib/help.lua
  rttlib/interface.lua
  rttlib/overview.lua
  rttlib/paint.lua
  rttlib/values.lua
  rttros.lua
  utils.lua)
set(copies)
foreach(module ${modules})
  set(copy ${PROJECT_BINARY_DIR}/share/lua/5.1/${module})
  add_custom_command(OUTPUT ${copy}
    COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_CURRENT_SOURCE_DIR}/lua/modules/${module} ${copy}
    DEPENDS lua/modules/${module} VERBATIM)
  list(APPEND copies ${copy})
  get_filename_component(folder ${module} DIRECTORY)
  install(FILES lua/modules/${module} DESTINATION share/lua/5.1/${folder} COMPONENT runtime)
endforeach()
add_custom_target(lua-modules ALL DEPENDS ${copies})
add_dependencies(orocos-ocl-lua lua-modules)
