# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# The packages of the family rtt_ros: libraries, plugins, and what is installed of them.
#
#   oroforge_ros_library(<package> <name> <source>…)     lib<name>-<target>.so in lib, which users link
#   oroforge_ros_components(<package> <name> <source>…)  a library of components, where import(<package>) finds it
#   oroforge_ros_plugin(<package> <name> <source>…)      a plugin in its folder plugins
#   oroforge_ros_typekit(<package> <name> <source>…)     a typekit or transport in its folder types
#   oroforge_ros_unit(<name> <unit> <source>…)           sources of <name> that are compiled as one: headers of ROS take longer
# All but the last make the target <name>. Headers are included as <package/file.h>.
#
#   oroforge_ros_package(<package> DESCRIPTION <text>
#     [DEPENDS <package>…]     of this family, made before: find_package() of the package finds them, too
#     [SYSTEM <package>…]      of ROS: users compile with their headers and link to their libraries
#     [MODULES <name>…]        of pkg-config, which users need besides: those of libraries that are not of ROS
#     [LIBRARIES <name>…]      what users link
#     [IMPORTS <package>…]     plugin_depend: what ros.import() of the package brings
#     [CMAKE <file>…]          included by find_package(), relative to the package's folder
#     [HEADERS <folder>])      whose *.h and *.hpp are installed; default the package's folder
# writes and installs package.xml, the CMake config, the pkg-config module and the headers.
include_guard(GLOBAL)

set(OROFORGE_ROS_DIR ${CMAKE_CURRENT_LIST_DIR})

function(_oroforge_ros_target name folder)
  target_include_directories(${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/ros> $<INSTALL_INTERFACE:include/orocos>)
  target_link_libraries(${name} PUBLIC orocos-rtt PkgConfig::ROSCPP)
  set_target_properties(${name} PROPERTIES
    OUTPUT_NAME ${name}-${OROCOS_TARGET}
    LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${folder}
    BUILD_RPATH_USE_ORIGIN ON)
  if(folder STREQUAL "lib")
    set_target_properties(${name} PROPERTIES INSTALL_RPATH "$ORIGIN")
  else()
    file(RELATIVE_PATH up /${folder} /lib)
    set_target_properties(${name} PROPERTIES INSTALL_RPATH "$ORIGIN/${up};$ORIGIN")
  endif()
  install(TARGETS ${name} LIBRARY DESTINATION ${folder} COMPONENT ros)
endfunction()

function(oroforge_ros_library package name)
  add_library(${name} SHARED ${ARGN})
  _oroforge_ros_target(${name} lib)
endfunction()

function(oroforge_ros_components package name)
  add_library(${name} SHARED ${ARGN})
  target_compile_definitions(${name} PRIVATE RTT_COMPONENT)
  _oroforge_ros_target(${name} ${OROFORGE_PLUGIN_DIR}/${package})
endfunction()

function(oroforge_ros_plugin package name)
  add_library(${name} MODULE ${ARGN})
  _oroforge_ros_target(${name} ${OROFORGE_PLUGIN_DIR}/${package}/plugins)
endfunction()

function(oroforge_ros_typekit package name)
  add_library(${name} SHARED ${ARGN})
  _oroforge_ros_target(${name} ${OROFORGE_PLUGIN_DIR}/${package}/types)
endfunction()

function(oroforge_ros_unit name unit)
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR}/ros ${CMAKE_CURRENT_SOURCE_DIR})
  list(TRANSFORM ARGN PREPEND ${folder}/ OUTPUT_VARIABLE sources)
  oroforge_unit(${name} ${unit} ${PROJECT_SOURCE_DIR}/ros ${sources})
endfunction()

function(oroforge_ros_package package)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "DESCRIPTION;HEADERS" "DEPENDS;SYSTEM;MODULES;LIBRARIES;IMPORTS;CMAKE")
  if(arg_UNPARSED_ARGUMENTS OR NOT arg_DESCRIPTION)
    message(FATAL_ERROR "oroforge_ros_package(${package}): no DESCRIPTION, or unknown arguments: ${arg_UNPARSED_ARGUMENTS}")
  endif()
  get_property(all GLOBAL PROPERTY OROFORGE_ROS_PACKAGES)
  foreach(name ${arg_DEPENDS})
    if(NOT name IN_LIST all)
      message(FATAL_ERROR "oroforge_ros_package(${package}): ${name}, on which it depends, was left out or comes later; "
        "leave ${package} out as well, or let ${name} be made before")
    endif()
  endforeach()
  set_property(GLOBAL APPEND PROPERTY OROFORGE_ROS_PACKAGES ${package})
  set(made ${PROJECT_BINARY_DIR}/share/${package})
  set(depends "")
  foreach(name ${arg_DEPENDS} ${arg_SYSTEM})
    string(APPEND depends "  <depend>${name}</depend>\n")
  endforeach()
  set(imports "")
  foreach(name ${arg_IMPORTS})
    string(APPEND imports "      <plugin_depend>${name}</plugin_depend>\n")
  endforeach()
  set(libs "")
  set(files "")
  foreach(name ${arg_LIBRARIES})
    get_target_property(folder ${name} LIBRARY_OUTPUT_DIRECTORY)
    file(RELATIVE_PATH folder ${PROJECT_BINARY_DIR} ${folder})
    string(APPEND libs " -L\${prefix}/${folder} -l${name}-${OROCOS_TARGET}")
    list(APPEND files ${folder}/lib${name}-${OROCOS_TARGET}.so)
  endforeach()
  set(includes "")
  foreach(file ${arg_CMAKE})
    get_filename_component(name ${file} NAME)
    configure_file(${file} ${made}/cmake/${name} COPYONLY)
    string(APPEND includes "include(\${CMAKE_CURRENT_LIST_DIR}/${name})\n")
  endforeach()
  set(requires orocos-rtt-${OROCOS_TARGET} ${arg_SYSTEM} ${arg_MODULES})
  foreach(name ${arg_DEPENDS})
    list(APPEND requires ${name}-${OROCOS_TARGET})
  endforeach()
  list(JOIN requires " " requires)
  configure_file(${OROFORGE_ROS_DIR}/package.xml.in ${made}/package.xml @ONLY)
  configure_file(${OROFORGE_ROS_DIR}/package-config.cmake.in ${made}/cmake/${package}Config.cmake @ONLY)
  include(CMakePackageConfigHelpers)
  write_basic_package_version_file(${made}/cmake/${package}Config-version.cmake
    VERSION ${PROJECT_VERSION} COMPATIBILITY SameMajorVersion)
  configure_file(${OROFORGE_ROS_DIR}/package.pc.in
    ${PROJECT_BINARY_DIR}/lib/pkgconfig/${package}-${OROCOS_TARGET}.pc @ONLY)
  install(DIRECTORY ${made}/cmake DESTINATION share/${package} COMPONENT ros)
  install(FILES ${made}/package.xml DESTINATION share/${package} COMPONENT ros)
  install(FILES ${PROJECT_BINARY_DIR}/lib/pkgconfig/${package}-${OROCOS_TARGET}.pc DESTINATION lib/pkgconfig COMPONENT ros)
  if(NOT arg_HEADERS)
    set(arg_HEADERS ${CMAKE_CURRENT_SOURCE_DIR})
  endif()
  install(DIRECTORY ${arg_HEADERS}/ DESTINATION include/orocos/${package} COMPONENT ros
    FILES_MATCHING PATTERN "*.h" PATTERN "*.hpp" REGEX "/(detail|cmake|launch|scripts|srv)$" EXCLUDE)
endfunction()
