# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
#
#   ros_generate_rtt_typekit(<package> [EXTRA_INCLUDES header…])
#     Makes the types of a message package known to components, and lets their ports be topics: the libraries
#     rtt-<package>-typekit and rtt-<package>-ros-transport of this project, and headers <<package>/typekit/Message.h>.
#   ros_generate_rtt_service_proxies(<package> [EXTRA_INCLUDES header…])
#     Makes the services of a package known to rosservice: the plugin rtt_<package>_rosservice_proxies.
#
# <package> is any package with .msg or .srv files, or this project, after generate_messages(). Both may be called for several
# packages in one project. A package without such files is no error. The options ENABLE_MQ and ENABLE_CORBA are accepted: the
# transports of the toolchain carry messages without libraries of their own.
option(ENABLE_MQ "Accepted for packages that set it: message queues carry all types" OFF)
option(ENABLE_CORBA "Accepted for packages that set it: CORBA carries all types" OFF)

if(NOT COMMAND orocos_typekit)
  find_package(OROCOS-RTT REQUIRED QUIET HINTS ${rtt_roscomm_PREFIX})
  include(${OROCOS-RTT_USE_FILE_PATH}/UseOROCOS-RTT.cmake)
endif()

# Folders with the .msg files of a package that was found, and of those that it names.
function(_rtt_ros_message_paths result package)
  set(open ${package} ${ARGN})
  set(seen "")
  set(paths "")
  while(open)
    list(POP_FRONT open name)
    if(name IN_LIST seen)
      continue()
    endif()
    list(APPEND seen ${name})
    if(NOT name STREQUAL PROJECT_NAME AND NOT ${name}_FOUND)
      find_package(${name} QUIET CONFIG)
    endif()
    if(NOT COMMAND _prepend_path)
      macro(_prepend_path folder files variable)
        set(${variable} ${files})
        list(TRANSFORM ${variable} PREPEND ${folder}/)
      endmacro()
    endif()
    if(EXISTS "${${name}_DIR}/${name}-msg-paths.cmake")
      include(${${name}_DIR}/${name}-msg-paths.cmake)
    endif()
    foreach(folder ${${name}_MSG_INCLUDE_DIRS} ${${name}_MSG_INCLUDE_DIRS_DEVELSPACE})
      list(APPEND paths ${name}=${folder})
    endforeach()
    list(APPEND open ${${name}_MSG_DEPENDENCIES})
  endwhile()
  set(${result} ${paths} PARENT_SCOPE)
endfunction()

# The .msg or .srv files of a package. An unknown package, or one whose files are not installed, is a fatal error.
function(_rtt_ros_files result macro package list)
  if(NOT package STREQUAL PROJECT_NAME AND NOT ${package}_FOUND)
    find_package(${package} QUIET CONFIG)
    if(NOT ${package}_FOUND)
      message(FATAL_ERROR "${macro}(${package}): there is no package '${package}'; searched as find_package() does: CMAKE_PREFIX_PATH is '${CMAKE_PREFIX_PATH};$ENV{CMAKE_PREFIX_PATH}'")
    endif()
  endif()
  set(files "")
  foreach(file ${${package}_${list}})
    if(NOT IS_ABSOLUTE ${file})
      set(base ${${package}_DIR}/..)
      if(package STREQUAL PROJECT_NAME)
        set(base ${PROJECT_SOURCE_DIR})
      endif()
      get_filename_component(file ${base}/${file} ABSOLUTE)
    endif()
    get_source_file_property(generated ${file} GENERATED)
    if(NOT EXISTS ${file} AND NOT generated)
      string(REPLACE "_" "-" debian ${package})
      message(FATAL_ERROR "${macro}(${package}): package '${package}' names ${file}, which does not exist (on Debian it is in the package ros-${debian})")
    endif()
    list(APPEND files ${file})
  endforeach()
  set(${result} ${files} PARENT_SCOPE)
endfunction()

# Says which packages with the types of fields are missing.
function(_rtt_ros_check_dependencies macro package)
  foreach(name ${ARGN})
    if(name STREQUAL package OR TARGET rtt-${name}-typekit)
      continue()
    endif()
    find_package(rtt_${name} QUIET CONFIG HINTS ${rtt_roscomm_PREFIX} PATH_SUFFIXES share)
    if(NOT rtt_${name}_FOUND)
      message(WARNING "${macro}(${package}): messages of ${package} have fields of package ${name}, but there is no package rtt_${name} with their types; call ros_generate_rtt_typekit(${name}), too, or make the package with: rosrun rtt_roscomm create_rtt_msgs ${name}")
    endif()
  endforeach()
endfunction()

# What typekits, transports and plugins of messages have in common.
function(_rtt_ros_finish target package)
  set_property(TARGET ${target} APPEND PROPERTY INCLUDE_DIRECTORIES
    ${rtt_roscomm_INCLUDE_DIRS} ${${package}_INCLUDE_DIRS} ${catkin_INCLUDE_DIRS})
  if(CATKIN_DEVEL_PREFIX)
    set_property(TARGET ${target} APPEND PROPERTY INCLUDE_DIRECTORIES ${CATKIN_DEVEL_PREFIX}/include)
  endif()
  # What users need is marked as visible: 40 % less to load.
  set_target_properties(${target} PROPERTIES CXX_VISIBILITY_PRESET hidden)
  target_link_libraries(${target} ${rtt_roscomm_LIBRARIES}
    ${rtt_roscomm_PREFIX}/lib/orocos/${OROCOS_TARGET}/rtt_ros/types/librtt-ros-primitives-typekit-${OROCOS_TARGET}.so)
endfunction()

# Headers of messages are made before what includes them. Called at the end of the directory: all targets exist by then.
function(_rtt_ros_build_after target package)
  foreach(made ${package}_generate_messages_cpp ${${package}_EXPORTED_TARGETS} ${catkin_EXPORTED_TARGETS})
    if(TARGET ${made})
      add_dependencies(${target} ${made})
    endif()
  endforeach()
endfunction()

# Both macros: sets _rtt_ros_files, and runs the generator if there are any.
macro(_rtt_ros_prepare macro kind package list)
  cmake_parse_arguments(_rtt_ros_arg "" "" "EXTRA_INCLUDES" ${ARGN})
  if(_rtt_ros_arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "${macro}(${package}): unknown arguments: ${_rtt_ros_arg_UNPARSED_ARGUMENTS}")
  endif()
  _rtt_ros_files(_rtt_ros_files ${macro} ${package} ${list})
  if(NOT _rtt_ros_files)
    message(STATUS "${macro}(${package}): package ${package} has none, nothing to do")
  else()
    _oro_find_generator(_rtt_ros_program typegen-ros)
    execute_process(COMMAND ${_rtt_ros_program} --dependencies ${package} ${_rtt_ros_files}
      OUTPUT_VARIABLE _rtt_ros_depends ERROR_VARIABLE _rtt_ros_errors RESULT_VARIABLE _rtt_ros_status OUTPUT_STRIP_TRAILING_WHITESPACE)
    if(NOT _rtt_ros_status EQUAL 0)
      message("${_rtt_ros_errors}")
      message(FATAL_ERROR "${macro}(${package}): the files of ${package} cannot be read, see above")
    endif()
    string(REPLACE "\n" ";" _rtt_ros_depends "${_rtt_ros_depends}")
    _rtt_ros_message_paths(_rtt_ros_paths ${package} ${_rtt_ros_depends})
    _rtt_ros_check_dependencies(${macro} ${package} ${_rtt_ros_depends})
    string(REPLACE ";" ":" _rtt_ros_prefixes "${CMAKE_PREFIX_PATH};$ENV{CMAKE_PREFIX_PATH}")
    _rtt_ros_generate(${kind} ${package} ${PROJECT_BINARY_DIR}/rtt_${package} FILES ${_rtt_ros_files}
      PROGRAM ${CMAKE_COMMAND} -E env "CMAKE_PREFIX_PATH=${_rtt_ros_prefixes}" ${_rtt_ros_program}
      PATHS ${_rtt_ros_paths} INCLUDES ${_rtt_ros_arg_EXTRA_INCLUDES} DEPENDS ${_rtt_ros_program})
    # The dependencies of the generator are those of the package's own files, which may be generated.
    cmake_language(EVAL CODE
      "cmake_language(DEFER CALL _rtt_ros_build_after [[rtt-${package}-${kind}-generate]] [[${package}]])")
  endif()
endmacro()

macro(ros_generate_rtt_typekit package)
  _rtt_ros_prepare(ros_generate_rtt_typekit messages ${package} MESSAGE_FILES ${ARGN})
  if(_rtt_ros_files)
    orocos_typekit(rtt-${package}-typekit ${_rtt_ros_sources})
    orocos_typekit(rtt-${package}-ros-transport ${_rtt_ros_transport})
    # As for typekits of typegen: nearly all of the time of loading is the look-up of type information, which is needless.
    set_property(TARGET rtt-${package}-typekit APPEND PROPERTY LINK_OPTIONS -Wl,-Bsymbolic)
    foreach(_rtt_ros_target rtt-${package}-typekit rtt-${package}-ros-transport)
      _rtt_ros_finish(${_rtt_ros_target} ${package})
      add_dependencies(${_rtt_ros_target} rtt-${package}-messages-generate)
    endforeach()
    _oro_add_project_includes(${PROJECT_BINARY_DIR}/rtt_${package}/include)
    _oro_add_project_generator(rtt-${package}-messages-generate)
    foreach(_rtt_ros_header ${_rtt_ros_headers})
      get_filename_component(_rtt_ros_folder ${_rtt_ros_header} DIRECTORY)
      get_filename_component(_rtt_ros_folder ${_rtt_ros_folder} NAME)
      install(FILES ${_rtt_ros_header} DESTINATION include/orocos/${package}/${_rtt_ros_folder})
    endforeach()
  endif()
endmacro()

macro(ros_generate_rtt_service_proxies package)
  _rtt_ros_prepare(ros_generate_rtt_service_proxies services ${package} SERVICE_FILES ${ARGN})
  if(_rtt_ros_files)
    orocos_plugin(rtt_${package}_rosservice_proxies ${_rtt_ros_sources})
    _rtt_ros_finish(rtt_${package}_rosservice_proxies ${package})
    add_dependencies(rtt_${package}_rosservice_proxies rtt-${package}-services-generate)
  endif()
endmacro()
