# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Private part of UseOrocos.cmake: orocos_typegen_headers(), based on OrocosGenerate.cmake.

# The absolute paths of the headers in the arguments, which may be folders. The next build notices headers that are added to a
# folder.
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

# Writes the compiler options of the typekit's sources, one word on a line, for typegen, which must read the headers in the
# same way. Called at the end of the directory, because a package may set flags or link libraries after the macro.
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

# <project/typekit/Types.hpp> declares instances that are in the library, so all targets that can include it are linked to
# the library, except its own parts. Called at the end of the project's directory, when all targets are known.
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

# Takes the arguments of orocos_typegen_headers() apart: options of typegen, and headers or folders.
function(_oro_split_typegen_arguments options files)
  set(words "")
  set(names "")
  set(valued FALSE)
  foreach(argument ${ARGN})
    if(argument MATCHES "^(-o|--output)")
      message(FATAL_ERROR "orocos_typegen_headers(): '${argument}' is not for a package to say; to keep the files in the source folder, use COMMITTED")
    elseif(valued OR argument MATCHES "^-")
      list(APPEND words ${argument})
    else()
      list(APPEND names ${argument})
    endif()
    set(valued FALSE)
    if(argument MATCHES "^(-[intIDUp]|-isystem|-include|--(import|transports|notransports|template-dir|adapters|pieces|compile-database|compile-database-for))$")
      set(valued TRUE)
    endif()
  endforeach()
  set(${options} ${words} PARENT_SCOPE)
  set(${files} ${names} PARENT_SCOPE)
endfunction()

# The include folders of the headers, and the options for typegen. Installs the headers. A header that is not below an include
# folder is included through another one, which is made in the given folder.
function(_oro_place_headers include_dirs options dir)
  set(folders "")
  set(words "")
  set(names "")
  foreach(header ${ARGN})
    _oro_include_name(name root ${header})
    if(name IN_LIST names)
      message(FATAL_ERROR "orocos_typegen_headers(): two headers would be included as <${name}>; the second is ${header}")
    endif()
    list(APPEND names ${name})
    list(APPEND words --include-as=${header}=${name})
    # Told, for the size that decides may be another when the files are written. The rule is that of typegen by itself.
    file(SIZE ${header} size)
    math(EXPR pieces "${size} / 4096 + 1")
    list(APPEND words --pieces=${header}=${pieces})
    if(NOT root)
      set(root ${dir})
      file(CONFIGURE OUTPUT ${root}/${name} CONTENT "// Made by orocos_typegen_headers().\n#include \"${header}\"\n" @ONLY)
      # Configures again if the file was removed.
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${root}/${name})
    endif()
    list(APPEND folders ${root})
    get_filename_component(folder ${name} DIRECTORY)
    install(FILES ${header} DESTINATION include/orocos/${folder})
  endforeach()
  list(REMOVE_DUPLICATES folders)
  set(${include_dirs} ${folders} PARENT_SCOPE)
  set(${options} ${words} PARENT_SCOPE)
endfunction()

# Runs typegen at build time, when a header (or what it includes), an option, or typegen itself has changed.
function(_oro_generate_typekit target command headers)
  set(stamp ${PROJECT_BINARY_DIR}/typekit.stamp)
  set(depfile ${PROJECT_BINARY_DIR}/typekit.d)
  _oro_forget_dependencies(forget ${target}-generate)
  add_custom_command(OUTPUT ${stamp} BYPRODUCTS ${ARGN}
    COMMAND ${command} --depfile=${depfile} --depfile-target=${stamp} ${PROJECT_NAME} ${headers}
    ${forget}
    COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
    DEPENDS ${headers} ${_oro_typegen_inputs}
    DEPFILE ${depfile}
    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
    COMMENT "Generating typekit ${PROJECT_NAME}" VERBATIM)
  add_custom_target(${target}-generate DEPENDS ${stamp})
  _oro_notice_removed(${target}-generate ${stamp} ${ARGN})
  _oro_add_project_generator(${target}-generate)
endfunction()

# Targets that compare committed files with the output of typegen, and that renew them; the former is a test, too.
function(_oro_check_committed target command headers dir)
  set(folder ${PROJECT_BINARY_DIR})
  if(folder MATCHES " ")
    set(folder "'${folder}'")
  endif()
  string(REPLACE ";" "\;" how "to refresh: cmake --build ${folder} --target ${target}-refresh")
  set(check ${command} "--check=${how}" ${PROJECT_NAME} ${headers})
  add_custom_target(${target}-check COMMAND ${check} WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
    COMMENT "Comparing typekit ${PROJECT_NAME} with its headers" VERBATIM)
  add_test(NAME ${target}-check COMMAND ${check} WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
  add_custom_target(${target}-refresh COMMAND ${command} ${PROJECT_NAME} ${headers}
    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} COMMENT "Generating typekit ${PROJECT_NAME} into ${dir}" VERBATIM)
endfunction()

# orocos_typegen_headers([typegen options] header… [DEPENDS pkg…] [ADAPTERS file…] [COMMITTED dir])
# Makes the typekit library <project>-typekit from C++ headers; generation happens at build time, and only when one of
# the headers (or what they include) changed. Installs the headers. A package named by DEPENDS is used as by
# orocos_use_package(), by the typekit alone.
# With COMMITTED the sources are those in that folder of the package, and typegen need not be installed. Where it is, the
# test <project>-typekit-check fails when they are not what the headers say, and the target <project>-typekit-refresh
# writes them.
function(_oro_typegen)
  cmake_parse_arguments(ARG "" "COMMITTED" "DEPENDS;ADAPTERS" ${ARGN})
  set(target ${PROJECT_NAME}-typekit)
  if(TARGET ${target})
    message(FATAL_ERROR "orocos_typegen_headers(): called a second time in project ${PROJECT_NAME}; list all headers in one call")
  endif()
  _oro_split_typegen_arguments(options files ${ARG_UNPARSED_ARGUMENTS})
  _oro_find_headers(headers ${files})
  set(dir ${PROJECT_BINARY_DIR}/typekit)
  set(committed "")
  if(ARG_COMMITTED)
    get_filename_component(committed ${ARG_COMMITTED} ABSOLUTE)
    _oro_find_generator(typegen typegen OPTIONAL)
    file(GLOB sources CONFIGURE_DEPENDS ${committed}/Plugin.cpp ${committed}/types_*.cpp)
    if(sources)
      set(dir ${committed})
    elseif(typegen)
      message(STATUS "typekit ${PROJECT_NAME}: nothing in ${committed} yet; the target ${target}-refresh writes it")
    else()
      message(FATAL_ERROR "orocos_typegen_headers(): no generated sources in ${committed}, and no program typegen to make them; commit what the target ${target}-refresh writes where typegen is installed")
    endif()
  else()
    _oro_find_generator(typegen typegen)
  endif()

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

  _oro_place_headers(include_dirs names ${PROJECT_BINARY_DIR}/typekit/include ${headers})
  list(PREPEND include_dirs ${dir}/types)
  _oro_add_project_includes(${include_dirs})

  set(flags ${PROJECT_BINARY_DIR}/typekit-flags)
  set(_oro_typegen_inputs ${typegen} ${flags}-CXX-$<CONFIG>.txt)
  foreach(file ${ARG_ADAPTERS})
    list(APPEND options --adapters=${file})
    get_filename_component(file ${file} ABSOLUTE)
    if(EXISTS ${file})
      list(APPEND _oro_typegen_inputs ${file})
    endif()
  endforeach()
  list(PREPEND options ${names})
  set(command ${CMAKE_COMMAND} -E env "PKG_CONFIG_PATH=$ENV{PKG_CONFIG_PATH}:${OROCOS-RTT_PATH}/lib/pkgconfig"
    ${typegen} ${options} --flags-from=${flags}-CXX-$<CONFIG>.txt -o)
  if(NOT dir STREQUAL committed)
    _oro_list_outputs(outputs ${typegen} -o ${dir} ${options} ${PROJECT_NAME} ${headers})
    _oro_generate_typekit(${target} "${command};${dir}" "${headers}" ${outputs})
    set(sources ${outputs})
    list(FILTER sources INCLUDE REGEX "\\.cpp$")
  endif()
  if(committed AND typegen)
    _oro_check_committed(${target} "${command};${committed}" "${headers}" ${committed})
  endif()

  _oro_add_target(typekit ${target} ${sources})
  # Nearly all of the time of loading it is the look-up of type information, which is needless: types are compared by name.
  set_property(TARGET ${target} APPEND PROPERTY LINK_OPTIONS -Wl,-Bsymbolic)
  set_property(TARGET ${target} APPEND PROPERTY INTERFACE_INCLUDE_DIRECTORIES $<BUILD_INTERFACE:${include_dirs}>)
  set_target_properties(${target} PROPERTIES OROCOS_TYPEKIT_DIR ${dir})
  add_library(${target}-${OROCOS_TARGET} ALIAS ${target})
  _oro_at_end(${PROJECT_SOURCE_DIR} "_oro_link_typekit [[${PROJECT_NAME}]]")
  # The name depends on the language, because options may; only the file for C++ is read.
  cmake_language(EVAL CODE
    "cmake_language(DEFER CALL _oro_write_compiler_flags [[${target}]] [[${flags}-$<COMPILE_LANGUAGE>-$<CONFIG>.txt]])")

  install(FILES ${dir}/types/${PROJECT_NAME}/typekit/Types.hpp DESTINATION include/orocos/${PROJECT_NAME}/typekit)
  _oro_write_pkg_config(${target}-${OROCOS_TARGET} 1.0 "${requires}"
    "-L\${orocos_libdir}/types;-l${target}-${OROCOS_TARGET}" "-I\${includedir}")
endfunction()

macro(orocos_typegen_headers)
  _oro_typegen(${ARGN})
  get_target_property(_oro_typekit_dirs ${PROJECT_NAME}-typekit OROCOS_TYPEKIT_DIR)
  list(APPEND ${PROJECT_NAME}_EXPORTED_INCLUDE_DIRS ${_oro_typekit_dirs}/types)
  _oro_list_target(typekit ${PROJECT_NAME}-typekit)
endmacro()
