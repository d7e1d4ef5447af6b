# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Private part of UseOrocos.cmake: code generated at build time by typegen and orocreate-pkg.
#
# A generator's OUTPUT is a stamp and its files are BYPRODUCTS: it does not touch files that would not change, so make, which
# compares times, would run it again at each build.

# Finds a generator beside this file's prefix. A package cannot be built without it, so it is a fatal error if it is missing,
# unless OPTIONAL is given.
function(_oro_find_generator result name)
  # Looked up each time, because a build folder may be switched to another toolchain.
  unset(OROCOS_${name}_PROGRAM CACHE)
  find_program(OROCOS_${name}_PROGRAM ${name} HINTS ${OROCOS-RTT_PATH}/bin NO_DEFAULT_PATH)
  if(NOT OROCOS_${name}_PROGRAM)
    find_program(OROCOS_${name}_PROGRAM ${name})
  endif()
  mark_as_advanced(OROCOS_${name}_PROGRAM)
  if(NOT OROCOS_${name}_PROGRAM AND NOT "${ARGN}" STREQUAL "OPTIONAL")
    message(FATAL_ERROR "program ${name} not found in ${OROCOS-RTT_PATH}/bin or on PATH; it belongs to the toolchain's installation")
  endif()
  set(${result} ${OROCOS_${name}_PROGRAM} PARENT_SCOPE)
endfunction()

# Output names depend only on the arguments, so asking for them is fast and the answer stays valid.
function(_oro_list_outputs result)
  execute_process(COMMAND ${ARGN} --list-outputs WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
    OUTPUT_VARIABLE text ERROR_VARIABLE errors RESULT_VARIABLE status OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT status EQUAL 0)
    # Without a mode, message() leaves lines as they are: editors read "file:line: error".
    message("${errors}")
    string(REPLACE ";" " " command "${ARGN}")
    message(FATAL_ERROR "this command failed (status ${status}), see above:\n  ${command} --list-outputs")
  endif()
  string(REPLACE "\n" ";" files "${text}")
  set(${result} ${files} PARENT_SCOPE)
endfunction()

# Adds include folders for all targets of the project, in all directories, earlier or later.
function(_oro_add_project_includes)
  set_property(GLOBAL APPEND PROPERTY OROCOS_${PROJECT_NAME}_INCLUDE_DIRS ${ARGN})
  get_property(made GLOBAL PROPERTY OROCOS_${PROJECT_NAME}_TARGETS)
  foreach(target ${made})
    set_property(TARGET ${target} APPEND PROPERTY INCLUDE_DIRECTORIES ${ARGN})
  endforeach()
endfunction()

# Makes all targets of the project depend on the generator's target.
function(_oro_add_project_generator target)
  if(NOT TARGET ${PROJECT_NAME}-generated)
    add_custom_target(${PROJECT_NAME}-generated)
  endif()
  add_dependencies(${PROJECT_NAME}-generated ${target})
  if(USE_OROCOS_EXPORTED_TARGETS)
    add_dependencies(${target} ${USE_OROCOS_EXPORTED_TARGETS})
  endif()
  get_property(made GLOBAL PROPERTY OROCOS_${PROJECT_NAME}_TARGETS)
  foreach(other ${made})
    add_dependencies(${other} ${target})
  endforeach()
endfunction()

# A command to run after a generator has written its dependency file, in the given target. With make, CMake keeps adding to
# its record of the earlier file; without the record, it reads the file anew.
function(_oro_forget_dependencies result target)
  set(command "")
  if(CMAKE_GENERATOR MATCHES "Makefiles")
    set(command COMMAND ${CMAKE_COMMAND} -E rm -f
      ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${target}.dir/compiler_depend.internal)
  endif()
  set(${result} ${command} PARENT_SCOPE)
endfunction()

# make does not know how to make a generated file that was removed, so this also removes the stamp before make checks it.
function(_oro_notice_removed target stamp)
  if(CMAKE_GENERATOR MATCHES "Makefiles")
    add_custom_target(${target}-look
      COMMAND sh -c "for file do [ -e \"$file\" ] || rm -f \"$0\"; done" ${stamp} ${ARGN} VERBATIM)
    add_dependencies(${target} ${target}-look)
  endif()
endfunction()

# orocos_generate_components(manifest.xml)
# Generates the base classes of the components that the manifest describes, at build time. Afterwards
# ${PROJECT_NAME}_GENERATED_SOURCES is to be listed among a component's sources, ${PROJECT_NAME}_<service>_GENERATED_SOURCES
# among those of a service; the include path is set by itself.
function(_oro_generate manifest)
  if(TARGET ${PROJECT_NAME}-components-generate)
    message(FATAL_ERROR "orocos_generate_components(${manifest}): called a second time in project ${PROJECT_NAME}; a project has one manifest, with all of its components")
  endif()
  _oro_find_generator(generator orocreate-pkg)
  set(dir ${PROJECT_BINARY_DIR}/generated)
  get_filename_component(path ${manifest} ABSOLUTE)
  if(NOT EXISTS ${path})
    message(FATAL_ERROR "orocos_generate_components(): no file '${manifest}' in ${CMAKE_CURRENT_SOURCE_DIR}")
  endif()
  # The files depend on the classes in the manifest, so configures again when it changes.
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
  set(command ${generator} --generate ${path} --output ${dir})
  _oro_list_outputs(outputs ${command})
  set(stamp ${PROJECT_BINARY_DIR}/generated.stamp)
  set(depfile ${PROJECT_BINARY_DIR}/generated.d)
  _oro_forget_dependencies(forget ${PROJECT_NAME}-components-generate)
  add_custom_command(OUTPUT ${stamp} BYPRODUCTS ${outputs}
    COMMAND ${command} --depfile ${depfile} --depfile-target ${stamp}
    ${forget}
    COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
    DEPENDS ${path} ${generator}
    DEPFILE ${depfile}
    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
    COMMENT "Generating component base classes of ${PROJECT_NAME}" VERBATIM)
  add_custom_target(${PROJECT_NAME}-components-generate DEPENDS ${stamp})
  _oro_notice_removed(${PROJECT_NAME}-components-generate ${stamp} ${outputs})
  _oro_add_project_generator(${PROJECT_NAME}-components-generate)
  _oro_add_project_includes(${dir})
  set_property(GLOBAL APPEND PROPERTY OROCOS_${PROJECT_NAME}_GENERATED_SOURCES ${outputs})
  # Each service has its own library; all components have one.
  set(sources ${outputs})
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  set(services ${sources})
  list(FILTER sources EXCLUDE REGEX "/services/[^/]+/[^/]+$")
  list(FILTER services INCLUDE REGEX "/services/[^/]+/[^/]+$")
  set(${PROJECT_NAME}_GENERATED_SOURCES ${sources} PARENT_SCOPE)
  foreach(file ${services})
    string(REGEX REPLACE ".*/services/([^/]+)/[^/]+$" "\\1" service ${file})
    list(APPEND ${service}_sources ${file})
    set(${PROJECT_NAME}_${service}_GENERATED_SOURCES ${${service}_sources} PARENT_SCOPE)
  endforeach()
  set(${PROJECT_NAME}_GENERATED_INCLUDE_DIR ${dir} PARENT_SCOPE)
  set(reference ${outputs})
  list(FILTER reference INCLUDE REGEX "/reference\\.md$")
  install(FILES ${reference} DESTINATION share/doc/${PROJECT_NAME})
  # The listed files, not the folder, because it may still have files of classes that were removed from the manifest.
  list(FILTER outputs INCLUDE REGEX "\\.hpp$")
  foreach(header ${outputs})
    file(RELATIVE_PATH name ${dir} ${header})
    get_filename_component(folder ${name} DIRECTORY)
    install(FILES ${header} DESTINATION include/orocos/${folder})
  endforeach()
endfunction()

macro(orocos_generate_components manifest)
  _oro_generate(${manifest})
endmacro()
