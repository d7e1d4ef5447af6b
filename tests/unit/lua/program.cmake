# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# The programs: rttlua as an interpreter of Lua, on a terminal, and with components.
set(base ${PROJECT_BINARY_DIR}/lib/orocos)
set(needed rttlua rttlua-tlsf rtt-typekit rtt-marshalling rtt-scripting orocos-ocl-helloworld orocos-ocl-timer oro
    orocos-ocl-live)

# Each program of Lua below language/ has to do the same there and in Debian's interpreter.
find_program(LUA_INTERPRETER lua5.1)
if(LUA_INTERPRETER)
  oroforge_add_script_test(lua.interpreter
    COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/interpreter_test.py
      $<TARGET_FILE:rttlua> ${base} ${LUA_INTERPRETER} $<TARGET_FILE:rttlua-tlsf>
    DEPENDS ${needed} TIMEOUT 300)
else()
  message(STATUS "left out: the test of rttlua as an interpreter, which needs lua5.1 (Debian: lua5.1)")
endif()

if(TARGET rttlua-corba)
  oroforge_add_script_test(lua.corba
    COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/corba_test.py $<TARGET_FILE:rttlua-corba> ${base}
    DEPENDS ${needed} rttlua-corba)
endif()

foreach(subject prompt program)
  oroforge_add_script_test(lua.${subject}
    COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/${subject}_test.py $<TARGET_FILE:rttlua> ${base}
    DEPENDS ${needed} TIMEOUT 300)
endforeach()
