# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# ORO_ADD_CORBA_SERVERS(<sources> <headers> <file.idl>…): adds to the variable <sources> what omniidl makes of each IDL
# file, <file>C.cc and <file>DynSK.cc in the build folder, and to <headers> the file <file>C.h, which has the interfaces
# and the skeletons. The files of the toolchain can be included: #include <rtt/transports/corba/TaskContext.idl>.
function(ORO_ADD_CORBA_SERVERS sources headers)
  find_program(OMNIIDL_COMMAND omniidl)
  mark_as_advanced(OMNIIDL_COMMAND)
  if(NOT OMNIIDL_COMMAND)
    message(FATAL_ERROR "ORO_ADD_CORBA_SERVERS: there is no program omniidl (Debian: package omniidl)")
  endif()
  set(made_sources ${${sources}})
  set(made_headers ${${headers}})
  foreach(idl ${ARGN})
    get_filename_component(idl "${idl}" ABSOLUTE)
    get_filename_component(folder "${idl}" DIRECTORY)
    get_filename_component(name "${idl}" NAME_WE)
    if(NOT EXISTS "${idl}")
      message(FATAL_ERROR "ORO_ADD_CORBA_SERVERS: there is no file ${idl}")
    endif()
    set(made ${CMAKE_CURRENT_BINARY_DIR}/${name}C.cc ${CMAKE_CURRENT_BINARY_DIR}/${name}DynSK.cc)
    set(header ${CMAKE_CURRENT_BINARY_DIR}/${name}C.h)
    add_custom_command(OUTPUT ${made} ${header}
      COMMAND ${OMNIIDL_COMMAND} -bcxx -Wbuse_quotes -Wba -Wbh=C.h -Wbs=C.cc -I${folder} -I${OROCOS-RTT_PATH}/include
        -C${CMAKE_CURRENT_BINARY_DIR} ${idl}
      DEPENDS ${idl} VERBATIM)
    list(APPEND made_sources ${made})
    list(APPEND made_headers ${header})
  endforeach()
  set(${sources} ${made_sources} PARENT_SCOPE)
  set(${headers} ${made_headers} PARENT_SCOPE)
endfunction()
