# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Private part of UseOrocos.cmake: code generated at build time by typegen and orocreate-pkg.

# Finds a generator beside this file's prefix; a package cannot be built without it, so a miss is fatal.
function(_oro_find_generator result name)
  find_program(OROCOS_${name}_PROGRAM ${name} HINTS ${OROCOS-RTT_PATH}/bin NO_DEFAULT_PATH)
  if(NOT OROCOS_${name}_PROGRAM)
    find_program(OROCOS_${name}_PROGRAM ${name})
  endif()
  mark_as_advanced(OROCOS_${name}_PROGRAM)
  if(NOT OROCOS_${name}_PROGRAM)
    message(FATAL_ERROR "program ${name} not found in ${OROCOS-RTT_PATH}/bin or on PATH; it belongs to the toolchain's installation")
  endif()
  set(${result} ${OROCOS_${name}_PROGRAM} PARENT_SCOPE)
endfunction()

# Output names are a function of the arguments alone, so asking for them is instant and cannot go stale.
function(_oro_list_outputs result)
  execute_process(COMMAND ${ARGN} --list-outputs WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
    OUTPUT_VARIABLE text ERROR_VARIABLE errors RESULT_VARIABLE status OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT status EQUAL 0)
    string(REPLACE ";" " " command "${ARGN}")
    message(FATAL_ERROR "this command failed (status ${status}):\n${command} --list-outputs\n${errors}")
  endif()
  string(REPLACE "\n" ";" files "${text}")
  set(${result} ${files} PARENT_SCOPE)
endfunction()

# The compiler settings of this directory that change what a header means, as options for typegen.
function(_oro_parse_flags result)
  set(flags "")
  get_directory_property(include_dirs INCLUDE_DIRECTORIES)
  if(EXISTS ${PROJECT_SOURCE_DIR}/include)
    list(APPEND include_dirs ${PROJECT_SOURCE_DIR}/include)
  endif()
  list(APPEND include_dirs ${USE_OROCOS_INCLUDE_DIRS} ${OROCOS-RTT_INCLUDE_DIRS})
  list(REMOVE_DUPLICATES include_dirs)
  foreach(dir ${include_dirs})
    list(APPEND flags -I${dir})
  endforeach()
  get_directory_property(definitions COMPILE_DEFINITIONS)
  foreach(definition ${definitions})
    if(NOT definition MATCHES "^OROCOS_TARGET=")
      list(APPEND flags -D${definition})
    endif()
  endforeach()
  if(CMAKE_CXX_STANDARD AND CMAKE_CXX_STANDARD GREATER 17 AND CMAKE_CXX_STANDARD LESS 90)
    list(APPEND flags -std=c++${CMAKE_CXX_STANDARD})
  elseif("${CMAKE_CXX_FLAGS}" MATCHES "-std=((c|gnu)\\+\\+(2[0-9a]))")
    list(APPEND flags -std=${CMAKE_MATCH_1})
  endif()
  set(${result} ${flags} PARENT_SCOPE)
endfunction()

# orocos_typegen_headers([typegen options] header… [DEPENDS pkg…])
# Makes the typekit library <project>-typekit from C++ headers; generation happens at build time, and only when one of
# the headers (or what they include) changed.
function(_oro_typegen)
  cmake_parse_arguments(ARG "" "" "DEPENDS" ${ARGN})
  _oro_find_generator(typegen typegen)
  set(target ${PROJECT_NAME}-typekit)
  set(dir ${PROJECT_BINARY_DIR}/typekit)
  set(options "")
  set(headers "")
  foreach(argument ${ARG_UNPARSED_ARGUMENTS})
    if(argument MATCHES "^-")
      list(APPEND options ${argument})
    else()
      list(APPEND headers ${argument})
      if(NOT EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${argument} AND NOT EXISTS ${argument})
        message(FATAL_ERROR "orocos_typegen_headers(): no file '${argument}' in ${CMAKE_CURRENT_SOURCE_DIR}")
      endif()
    endif()
  endforeach()
  if(NOT headers)
    message(FATAL_ERROR "orocos_typegen_headers(): no header given")
  endif()
  foreach(package ${ARG_DEPENDS})
    list(APPEND options -i ${package})
  endforeach()
  _oro_parse_flags(flags)

  set(command ${typegen} -o ${dir} ${options} ${flags})
  _oro_list_outputs(outputs ${command} ${PROJECT_NAME} ${headers})
  set(depfile ${PROJECT_BINARY_DIR}/typekit.d)
  add_custom_command(OUTPUT ${outputs}
    COMMAND ${CMAKE_COMMAND} -E env "PKG_CONFIG_PATH=$ENV{PKG_CONFIG_PATH}:${OROCOS-RTT_PATH}/lib/pkgconfig"
            ${command} --depfile ${depfile} ${PROJECT_NAME} ${headers}
    DEPENDS ${headers} ${typegen}
    DEPFILE ${depfile}
    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
    COMMENT "Generating typekit ${PROJECT_NAME}" VERBATIM)
  add_custom_target(${target}-generate DEPENDS ${outputs})

  set(${PROJECT_NAME}_TYPEKIT_INCLUDE_DIR ${dir}/types PARENT_SCOPE)
  set(${PROJECT_NAME}_TYPEKIT_INCLUDE_DIR ${dir}/types)
  set(sources ${outputs})
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  _oro_add_library(typekit ${target} ${sources})
  add_dependencies(${target} ${target}-generate)
  if(EXISTS ${PROJECT_SOURCE_DIR}/include)
    set_property(TARGET ${target} APPEND PROPERTY INCLUDE_DIRECTORIES ${PROJECT_SOURCE_DIR}/include)
  endif()
  set_property(TARGET ${target} APPEND PROPERTY INTERFACE_INCLUDE_DIRECTORIES $<BUILD_INTERFACE:${dir}/types>)
  add_library(${target}-${OROCOS_TARGET} ALIAS ${target})

  # Targets of this package may include <project/typekit/Types.hpp>, wherever and whenever they were made.
  get_property(made GLOBAL PROPERTY OROCOS_${PROJECT_NAME}_TARGETS)
  foreach(other ${made})
    if(NOT other STREQUAL target)
      set_property(TARGET ${other} APPEND PROPERTY INCLUDE_DIRECTORIES ${dir}/types)
      add_dependencies(${other} ${target}-generate)
    endif()
  endforeach()
  if(NOT TARGET ${PROJECT_NAME}-generated)
    add_custom_target(${PROJECT_NAME}-generated)
  endif()
  add_dependencies(${PROJECT_NAME}-generated ${target}-generate)

  install(DIRECTORY ${dir}/types/ DESTINATION include/orocos FILES_MATCHING PATTERN "*.hpp")
  _oro_write_pkg_config(${target}-${OROCOS_TARGET} 1.0 "" "-L\${orocos_libdir}/types -l${target}-${OROCOS_TARGET}"
    "-I\${includedir}")
endfunction()

macro(orocos_typegen_headers)
  _oro_typegen(${ARGN})
  list(APPEND OROCOS_DEFINED_TYPES ${PROJECT_NAME}-typekit)
  list(APPEND ${PROJECT_NAME}_EXPORTED_LIBRARIES ${PROJECT_NAME}-typekit)
  list(APPEND ${PROJECT_NAME}_EXPORTED_INCLUDE_DIRS ${PROJECT_BINARY_DIR}/typekit/types)
endmacro()

# orocos_generate_components(manifest.xml)
# Generates the base classes of the components that the manifest describes, at build time. Afterwards
# ${PROJECT_NAME}_GENERATED_SOURCES is to be listed among a component's sources; the include path is set by itself.
function(_oro_generate manifest)
  _oro_find_generator(generator orocreate-pkg)
  set(dir ${PROJECT_BINARY_DIR}/generated)
  get_filename_component(path ${manifest} ABSOLUTE)
  if(NOT EXISTS ${path})
    message(FATAL_ERROR "orocos_generate_components(): no file '${manifest}' in ${CMAKE_CURRENT_SOURCE_DIR}")
  endif()
  # The classes in the manifest decide which files there are: configure again when it changes.
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
  set(command ${generator} --generate ${manifest} --output ${dir})
  _oro_list_outputs(outputs ${command})
  set(depfile ${PROJECT_BINARY_DIR}/generated.d)
  add_custom_command(OUTPUT ${outputs}
    COMMAND ${command} --depfile ${depfile}
    DEPENDS ${path} ${generator}
    DEPFILE ${depfile}
    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
    COMMENT "Generating component base classes of ${PROJECT_NAME}" VERBATIM)
  add_custom_target(${PROJECT_NAME}-components-generate DEPENDS ${outputs})
  if(NOT TARGET ${PROJECT_NAME}-generated)
    add_custom_target(${PROJECT_NAME}-generated)
  endif()
  add_dependencies(${PROJECT_NAME}-generated ${PROJECT_NAME}-components-generate)
  set(sources ${outputs})
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  set(${PROJECT_NAME}_GENERATED_SOURCES ${sources} PARENT_SCOPE)
  set(${PROJECT_NAME}_GENERATED_INCLUDE_DIR ${dir} PARENT_SCOPE)
  install(DIRECTORY ${dir}/ DESTINATION include/orocos FILES_MATCHING PATTERN "*.hpp")
endfunction()

macro(orocos_generate_components manifest)
  _oro_generate(${manifest})
endmacro()
