# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Private part of UseOrocos.cmake: code generated at build time by typegen and orocreate-pkg.
#
# A generator's OUTPUT is a stamp, its files are BYPRODUCTS: it leaves files alone that would not change, and make, which
# compares times, would otherwise run it again at every build.

# Finds a generator beside this file's prefix; a package cannot be built without it, so a miss is fatal.
function(_oro_find_generator result name)
  # Looked for each time: a build folder may be switched to another toolchain.
  unset(OROCOS_${name}_PROGRAM CACHE)
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
    # Without a mode, message() leaves lines as they are: editors read "file:line: error".
    message("${errors}")
    string(REPLACE ";" " " command "${ARGN}")
    message(FATAL_ERROR "this command failed (status ${status}), see above:\n  ${command} --list-outputs")
  endif()
  string(REPLACE "\n" ";" files "${text}")
  set(${result} ${files} PARENT_SCOPE)
endfunction()

# The headers that the arguments name, folders searched, as absolute paths. A header that is added to a folder later is
# noticed by the next build.
function(_oro_find_headers result)
  set(headers "")
  foreach(argument ${ARGN})
    get_filename_component(path ${argument} ABSOLUTE)
    if(IS_DIRECTORY ${path})
      file(GLOB_RECURSE found CONFIGURE_DEPENDS ${path}/*.h ${path}/*.hh ${path}/*.hpp ${path}/*.hxx)
      list(FILTER found EXCLUDE REGEX "Typekit[^/]*$")
      if(NOT found)
        message(FATAL_ERROR "orocos_typegen_headers(): no headers (*.h, *.hh, *.hpp, *.hxx) in ${path}")
      endif()
      list(APPEND headers ${found})
    elseif(EXISTS ${path})
      list(APPEND headers ${path})
    else()
      message(FATAL_ERROR "orocos_typegen_headers(): no file '${argument}' in ${CMAKE_CURRENT_SOURCE_DIR}")
    endif()
  endforeach()
  if(NOT headers)
    message(FATAL_ERROR "orocos_typegen_headers(): no header given")
  endif()
  list(REMOVE_DUPLICATES headers)
  set(${result} ${headers} PARENT_SCOPE)
endfunction()

# How a header is included by generated code and by other packages, and the folder that this is relative to.
# include/folder/x.hpp is <folder/x.hpp>. Any other is <project/x.hpp>, or <project/folder/x.hpp> if it lies in a folder;
# then there is no such folder and ${root} is empty.
function(_oro_include_name name root header)
  file(RELATIVE_PATH path ${PROJECT_SOURCE_DIR} ${header})
  if(path MATCHES "^\\.\\./")
    set(path ${header})
  endif()
  if(path MATCHES "^(.*/)?include/([^/]+/.+)$")
    set(${name} ${CMAKE_MATCH_2} PARENT_SCOPE)
    string(LENGTH "${header}" length)
    string(LENGTH "/${CMAKE_MATCH_2}" below)
    math(EXPR length "${length} - ${below}")
    string(SUBSTRING "${header}" 0 ${length} folder)
    set(${root} ${folder} PARENT_SCOPE)
    return()
  endif()
  get_filename_component(file ${path} NAME)
  get_filename_component(folder ${path} DIRECTORY)
  get_filename_component(folder "${folder}" NAME)
  if(NOT folder STREQUAL "" AND NOT folder STREQUAL "include" AND NOT folder STREQUAL PROJECT_NAME)
    set(file ${folder}/${file})
  endif()
  set(${name} ${PROJECT_NAME}/${file} PARENT_SCOPE)
  set(${root} "" PARENT_SCOPE)
endfunction()

# Folders that every target of the project can include from, whichever directory it is made in, and whenever.
function(_oro_add_project_includes)
  set_property(GLOBAL APPEND PROPERTY OROCOS_${PROJECT_NAME}_INCLUDE_DIRS ${ARGN})
  get_property(made GLOBAL PROPERTY OROCOS_${PROJECT_NAME}_TARGETS)
  foreach(target ${made})
    set_property(TARGET ${target} APPEND PROPERTY INCLUDE_DIRECTORIES ${ARGN})
  endforeach()
endfunction()

# Every target of the project is built after the generator's target.
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

# What the compiler is told about the typekit's sources, one word a line, for typegen, which has to see the headers in
# the same way. Called at the end of the directory: a package may set flags, or link libraries, below the macro.
function(_oro_write_compiler_flags target file)
  _oro_directory_flags(flags)
  get_target_property(target_flags ${target} COMPILE_FLAGS)
  if(target_flags)
    string(APPEND flags " ${target_flags}")
  endif()
  separate_arguments(flags UNIX_COMMAND "${flags}")
  get_target_property(standard ${target} CXX_STANDARD)
  get_target_property(features ${target} COMPILE_FEATURES)
  foreach(level 20 23 26)
    if("${standard};${features}" MATCHES "(^|;|_)${level}(;|$)")
      list(PREPEND flags -std=c++${level})
    endif()
  endforeach()
  list(JOIN flags "\n" flags)
  set(includes "$<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>")
  set(definitions "$<TARGET_PROPERTY:${target},COMPILE_DEFINITIONS>")
  set(options "$<TARGET_PROPERTY:${target},COMPILE_OPTIONS>")
  file(GENERATE OUTPUT ${file} CONTENT
"$<$<BOOL:${definitions}>:-D$<JOIN:${definitions},\n-D>>
$<$<BOOL:${includes}>:-I$<JOIN:${includes},\n-I>>
${flags}
$<JOIN:${options},\n>
" TARGET ${target})
endfunction()

# Adds the targets that a target is linked to, and what those are linked to.
function(_oro_collect_linked result target)
  get_target_property(libraries ${target} LINK_LIBRARIES)
  set(all ${${result}})
  foreach(library ${libraries})
    if(TARGET ${library} AND NOT library IN_LIST all)
      list(APPEND all ${library})
      _oro_collect_linked(all ${library})
    endif()
  endforeach()
  set(${result} ${all} PARENT_SCOPE)
endfunction()

# <project/typekit/Types.hpp> declares instances that are in the library, so whoever can include it is linked to it,
# unless it is part of the typekit. Called at the end of the project's directory, when all targets are known.
function(_oro_link_typekit project)
  set(parts ${project}-typekit)
  _oro_collect_linked(parts ${project}-typekit)
  get_property(made GLOBAL PROPERTY OROCOS_${project}_TARGETS)
  foreach(target ${made})
    if(NOT target IN_LIST parts)
      set_property(TARGET ${target} APPEND PROPERTY LINK_LIBRARIES ${project}-typekit)
    endif()
  endforeach()
endfunction()

# orocos_typegen_headers([typegen options] header… [DEPENDS pkg…])
# Makes the typekit library <project>-typekit from C++ headers; generation happens at build time, and only when one of
# the headers (or what they include) changed. Installs the headers. A package named by DEPENDS is used as by
# orocos_use_package(), by the typekit alone.
function(_oro_typegen)
  cmake_parse_arguments(ARG "" "" "DEPENDS" ${ARGN})
  set(target ${PROJECT_NAME}-typekit)
  if(TARGET ${target})
    message(FATAL_ERROR "orocos_typegen_headers(): called a second time in project ${PROJECT_NAME}; list all headers in one call")
  endif()
  _oro_find_generator(typegen typegen)
  set(dir ${PROJECT_BINARY_DIR}/typekit)
  set(options "")
  set(files "")
  set(valued FALSE)
  foreach(argument ${ARG_UNPARSED_ARGUMENTS})
    if(valued OR argument MATCHES "^-")
      list(APPEND options ${argument})
    else()
      list(APPEND files ${argument})
    endif()
    set(valued FALSE)
    if(argument MATCHES "^(-[intIDU]|-isystem|-include|--import|--transports|--notransports|--template-dir)$")
      set(valued TRUE)
    endif()
  endforeach()
  _oro_find_headers(headers ${files})

  # In the scope of this function: nothing that is made later uses these packages.
  set(requires "")
  foreach(package ${ARG_DEPENDS})
    orocos_use_package(${package})
    if(NOT ${package}_FOUND)
      set(package ${package}-typekit)  # of a project that installs nothing else
      orocos_use_package(${package} REQUIRED)
    endif()
    list(APPEND requires ${package}-${OROCOS_TARGET})
  endforeach()

  set(include_dirs ${dir}/types)
  set(names "")
  foreach(header ${headers})
    _oro_include_name(name root ${header})
    if(name IN_LIST names)
      message(FATAL_ERROR "orocos_typegen_headers(): two headers would be included as <${name}>; the second is ${header}")
    endif()
    list(APPEND names ${name})
    list(APPEND options --include-as=${header}=${name})
    if(NOT root)
      set(root ${dir}/include)
      file(CONFIGURE OUTPUT ${root}/${name} CONTENT "// Made by orocos_typegen_headers().\n#include \"${header}\"\n" @ONLY)
    endif()
    list(APPEND include_dirs ${root})
    get_filename_component(folder ${name} DIRECTORY)
    install(FILES ${header} DESTINATION include/orocos/${folder})
  endforeach()
  list(REMOVE_DUPLICATES include_dirs)
  _oro_add_project_includes(${include_dirs})

  set(command ${typegen} -o ${dir} ${options})
  _oro_list_outputs(outputs ${command} ${PROJECT_NAME} ${headers})
  set(stamp ${PROJECT_BINARY_DIR}/typekit.stamp)
  set(depfile ${PROJECT_BINARY_DIR}/typekit.d)
  set(flags ${PROJECT_BINARY_DIR}/typekit-flags)
  add_custom_command(OUTPUT ${stamp} BYPRODUCTS ${outputs}
    COMMAND ${CMAKE_COMMAND} -E env "PKG_CONFIG_PATH=$ENV{PKG_CONFIG_PATH}:${OROCOS-RTT_PATH}/lib/pkgconfig"
            ${command} --flags-from=${flags}-CXX-$<CONFIG>.txt --depfile=${depfile} --depfile-target=${stamp}
            ${PROJECT_NAME} ${headers}
    COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
    DEPENDS ${headers} ${typegen} ${flags}-CXX-$<CONFIG>.txt
    DEPFILE ${depfile}
    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
    COMMENT "Generating typekit ${PROJECT_NAME}" VERBATIM)
  add_custom_target(${target}-generate DEPENDS ${stamp})
  _oro_add_project_generator(${target}-generate)

  set(sources ${outputs})
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  _oro_add_target(typekit ${target} ${sources})
  # Nearly all that loading it costs is looking up the type information of its classes. Types are told apart by name.
  set_property(TARGET ${target} APPEND PROPERTY LINK_OPTIONS -Wl,-Bsymbolic)
  set_property(TARGET ${target} APPEND PROPERTY INTERFACE_INCLUDE_DIRECTORIES $<BUILD_INTERFACE:${include_dirs}>)
  add_library(${target}-${OROCOS_TARGET} ALIAS ${target})
  cmake_language(EVAL CODE
    "cmake_language(DEFER DIRECTORY [[${PROJECT_SOURCE_DIR}]] CALL _oro_link_typekit [[${PROJECT_NAME}]])")
  # The name depends on the language because options may; only that of C++ is read.
  cmake_language(EVAL CODE
    "cmake_language(DEFER CALL _oro_write_compiler_flags [[${target}]] [[${flags}-$<COMPILE_LANGUAGE>-$<CONFIG>.txt]])")

  install(FILES ${dir}/types/${PROJECT_NAME}/typekit/Types.hpp DESTINATION include/orocos/${PROJECT_NAME}/typekit)
  list(JOIN requires " " requires)
  _oro_write_pkg_config(${target}-${OROCOS_TARGET} 1.0 "${requires}"
    "-L\${orocos_libdir}/types -l${target}-${OROCOS_TARGET}" "-I\${includedir}")
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
  set(command ${generator} --generate ${path} --output ${dir})
  _oro_list_outputs(outputs ${command})
  set(stamp ${PROJECT_BINARY_DIR}/generated.stamp)
  set(depfile ${PROJECT_BINARY_DIR}/generated.d)
  add_custom_command(OUTPUT ${stamp} BYPRODUCTS ${outputs}
    COMMAND ${command} --depfile ${depfile} --depfile-target ${stamp}
    COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
    DEPENDS ${path} ${generator}
    DEPFILE ${depfile}
    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
    COMMENT "Generating component base classes of ${PROJECT_NAME}" VERBATIM)
  add_custom_target(${PROJECT_NAME}-components-generate DEPENDS ${stamp})
  _oro_add_project_generator(${PROJECT_NAME}-components-generate)
  _oro_add_project_includes(${dir})
  set_property(GLOBAL APPEND PROPERTY OROCOS_${PROJECT_NAME}_GENERATED_SOURCES ${outputs})
  set(sources ${outputs})
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  set(${PROJECT_NAME}_GENERATED_SOURCES ${sources} PARENT_SCOPE)
  set(${PROJECT_NAME}_GENERATED_INCLUDE_DIR ${dir} PARENT_SCOPE)
  # The listed files, not the folder: it may hold those of classes that are no longer in the manifest.
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
