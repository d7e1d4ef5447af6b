# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Private: a rule that runs typegen-ros when a .msg file changed. Used by the toolchain's own build, too.

# _rtt_ros_generate(<messages|services> <package> <folder> FILES file… PROGRAM word… [PATHS package=folder…] [INCLUDES header…]
#   [DEPENDS file-or-target…])
# Makes the target rtt-<package>-<messages|services>-generate and sets, in the scope of the call, _rtt_ros_sources (of types and
# of the plugin), _rtt_ros_transport and _rtt_ros_headers. Files whose text does not change keep their time, and so does what is
# compiled from them.
function(_rtt_ros_generate kind package dir)
  cmake_parse_arguments(ARG "" "" "FILES;PROGRAM;PATHS;INCLUDES;DEPENDS" ${ARGN})
  set(each 6)  # messages in a source file: the headers of one file cost a second, as do two messages
  set(names "")
  set(headers "")
  foreach(file ${ARG_FILES})
    get_filename_component(name ${file} NAME_WE)
    if(kind STREQUAL "services")
      list(APPEND names ${name}Request ${name}Response)
    else()
      list(APPEND names ${name})
      list(APPEND headers ${dir}/include/${package}/typekit/${name}.h ${dir}/include/${package}/boost/${name}.h)
    endif()
  endforeach()
  # The names that typegen-ros --list-outputs tells: it may not be built yet.
  set(sources "")
  set(number 0)
  foreach(name ${names})
    math(EXPR first "${number} % ${each}")
    if(first EQUAL 0)
      list(APPEND sources ${dir}/types_${name}.cpp)
    endif()
    math(EXPR number "${number} + 1")
  endforeach()
  set(transport "")
  if(kind STREQUAL "services")
    list(APPEND sources ${dir}/Services.cpp)
  else()
    list(APPEND sources ${dir}/Plugin.cpp)
    set(transport ${dir}/Transport.cpp)
    list(APPEND headers ${dir}/include/${package}/typekit/Types.h ${dir}/include/${package}/typekit/Types.hpp)
  endif()

  set(words --${kind} ${package} ${ARG_FILES} -o ${dir} --per-source=${each})
  foreach(path ${ARG_PATHS})
    list(APPEND words --path=${path})
  endforeach()
  foreach(header ${ARG_INCLUDES})
    list(APPEND words --include=${header})
  endforeach()
  set(target rtt-${package}-${kind}-generate)
  set(stamp ${dir}/${kind}.stamp)
  set(depfile ${dir}/${kind}.d)
  set(outputs ${sources} ${transport} ${headers})
  _oro_forget_dependencies(forget ${target})
  add_custom_command(OUTPUT ${stamp} BYPRODUCTS ${outputs}
    COMMAND ${ARG_PROGRAM} ${words} --depfile=${depfile} --depfile-target=${stamp}
    ${forget}
    COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
    DEPENDS ${ARG_FILES} ${ARG_DEPENDS}
    DEPFILE ${depfile}
    COMMENT "Generating the ${kind} of ${package}" VERBATIM)
  add_custom_target(${target} DEPENDS ${stamp})
  _oro_notice_removed(${target} ${stamp} ${outputs})
  set_source_files_properties(${outputs} PROPERTIES GENERATED TRUE)
  set(_rtt_ros_sources ${sources} PARENT_SCOPE)
  set(_rtt_ros_transport ${transport} PARENT_SCOPE)
  set(_rtt_ros_headers ${headers} PARENT_SCOPE)
endfunction()
