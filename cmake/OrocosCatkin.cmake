# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Private part of UseOrocos.cmake: where a project is built: by plain CMake; by catkin, which builds libraries into a "devel
# space" (CATKIN_DEVEL_PREFIX), a prefix that is used like an installed one; or by rosbuild, where the source folder of a
# package is such a prefix. Neither of the latter is required.

# catkin expects catkin_pkg in the first python3 on PATH, unless PYTHON_EXECUTABLE is set. This sets it, before catkin is
# looked up, to a python3 that has catkin_pkg, if there is one.
function(_oro_choose_catkin_python)
  if(PYTHON_EXECUTABLE)
    return()
  endif()
  find_program(_oro_first_python NAMES python3)
  set(candidates ${_oro_first_python} /usr/bin/python3)
  unset(_oro_first_python CACHE)
  foreach(python ${candidates})
    execute_process(COMMAND ${python} -c "import catkin_pkg" RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
    if(status STREQUAL "0")
      set(PYTHON_EXECUTABLE ${python} CACHE FILEPATH "The python3 that catkin uses; it needs the module catkin_pkg")
      return()
    endif()
  endforeach()
  message(STATUS "catkin needs a python3 with the module catkin_pkg, and the first on PATH has none: "
    "where there is one, pass -DPYTHON_EXECUTABLE=<it>")
endfunction()

# Finds out whether package.xml says that catkin builds the package.
function(_oro_names_catkin result)
  set(lines "")
  if(EXISTS ${PROJECT_SOURCE_DIR}/package.xml)
    file(STRINGS ${PROJECT_SOURCE_DIR}/package.xml lines REGEX "<buildtool_depend[^>]*>[ \t]*catkin[ \t]*<")
  endif()
  if(lines)
    set(${result} TRUE PARENT_SCOPE)
  else()
    set(${result} FALSE PARENT_SCOPE)
  endif()
endfunction()

# Sets _oro_devel to the devel space, or to nothing where there is none.
macro(_oro_choose_flavour)
  set(_oro_devel "")
  set(_oro_rosbuild FALSE)
  if(DEFINED ORO_USE_ROSBUILD)
    set(_oro_rosbuild ${ORO_USE_ROSBUILD})
  elseif(COMMAND rosbuild_init)
    set(_oro_rosbuild TRUE)
  endif()
  set(_oro_catkin FALSE)
  if(_oro_rosbuild)
    set(_oro_devel ${PROJECT_SOURCE_DIR})
  elseif(DEFINED ORO_USE_CATKIN)
    set(_oro_catkin ${ORO_USE_CATKIN})
  elseif((catkin_FOUND OR CATKIN_DEVEL_PREFIX) AND EXISTS ${PROJECT_SOURCE_DIR}/package.xml)
    set(_oro_catkin TRUE)
  endif()
  if(_oro_catkin)
    if(NOT CATKIN_DEVEL_PREFIX)
      _oro_choose_catkin_python()
      find_package(catkin QUIET)
    endif()
    if(NOT CATKIN_DEVEL_PREFIX)
      set(CATKIN_DEVEL_PREFIX ${CMAKE_BINARY_DIR}/devel)
      message(STATUS "ORO_USE_CATKIN without catkin: the devel space is ${CATKIN_DEVEL_PREFIX}")
    endif()
    get_filename_component(_oro_devel ${CATKIN_DEVEL_PREFIX} ABSOLUTE BASE_DIR ${CMAKE_BINARY_DIR})
  elseif(NOT _oro_rosbuild AND NOT DEFINED ORO_USE_CATKIN)
    # The package may look for catkin later.
    _oro_names_catkin(_oro_later)
    if(_oro_later)
      _oro_choose_catkin_python()
    endif()
  endif()
endmacro()

# ORO_{COMPONENT,TYPEKIT,PLUGIN}_OUTPUT_DIRECTORY. A package may set them to other folders. Values set here for one project
# are not used for the next one, which inherits the variables.
macro(_oro_set_output_directories)
  foreach(_oro_kind COMPONENT TYPEKIT PLUGIN)
    _oro_default_output(${_oro_kind} _oro_default_${_oro_kind}_new)
    if(NOT ORO_${_oro_kind}_OUTPUT_DIRECTORY OR "${ORO_${_oro_kind}_OUTPUT_DIRECTORY}" STREQUAL "${_oro_default_${_oro_kind}}")
      set(ORO_${_oro_kind}_OUTPUT_DIRECTORY ${_oro_default_${_oro_kind}_new})
    endif()
    set(_oro_default_${_oro_kind} ${_oro_default_${_oro_kind}_new})
  endforeach()
endmacro()

# The default folder in which libraries of a kind are built.
function(_oro_default_output kind result)
  set(COMPONENT "")
  set(TYPEKIT /types)
  set(PLUGIN /plugins)
  set(base ${PROJECT_BINARY_DIR})
  if(_oro_devel)
    set(base ${_oro_devel}/lib)
  elseif(CMAKE_LIBRARY_OUTPUT_DIRECTORY)
    set(base ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})
  endif()
  set(${result} ${base}/orocos${OROCOS_SUFFIX}/${PROJECT_NAME}${${kind}} PARENT_SCOPE)
endfunction()

# The folder in which a target of the kind is built; the package may have set the variable, or
# CMAKE_LIBRARY_OUTPUT_DIRECTORY, after it included the macros.
function(_oro_output_directory kind result)
  _oro_default_output(${kind} directory)
  if(NOT "${ORO_${kind}_OUTPUT_DIRECTORY}" STREQUAL "${_oro_default_${kind}}" AND ORO_${kind}_OUTPUT_DIRECTORY)
    get_filename_component(directory ${ORO_${kind}_OUTPUT_DIRECTORY} ABSOLUTE BASE_DIR ${PROJECT_BINARY_DIR})
  endif()
  set(${result} ${directory} PARENT_SCOPE)
endfunction()

# The pkg-config file of the devel space: folders of the source and of the build tree.
function(_oro_write_devel_pkg_config name version requires targets include_dirs)
  set(libs "")
  foreach(target ${targets})
    _oro_library_directory(dir ${target})
    get_target_property(type ${target} TYPE)
    get_target_property(kind ${target} OROCOS_KIND)
    if(kind STREQUAL "component" AND type STREQUAL "STATIC_LIBRARY")
      _oro_whole_archive(whole ${dir}/lib${target}-${OROCOS_TARGET}.a)
      list(APPEND libs ${whole})
    else()
      list(APPEND libs -L${dir} -l${target}-${OROCOS_TARGET})
    endif()
  endforeach()
  list(REMOVE_DUPLICATES libs)
  set(cflags ${include_dirs})
  if(_oro_rosbuild)
    # Old packages include files by their path below the folder of all packages.
    list(APPEND cflags ${_oro_devel}/..)
  endif()
  list(TRANSFORM cflags PREPEND -I)
  _oro_configure_pkg_config(${_oro_devel}/lib/pkgconfig/${name}.pc ${_oro_devel} "${name}" "${version}" "${requires}"
    "${libs}" "${cflags}")
endfunction()

# catkin requires each package to call catkin_package(), so this calls it for packages that do not.
macro(_oro_catkin_package)
  if(_oro_catkin AND COMMAND catkin_package AND NOT ${PROJECT_NAME}_CATKIN_PACKAGE)
    catkin_package()
  endif()
endmacro()
