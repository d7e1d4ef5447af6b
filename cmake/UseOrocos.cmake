# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
#
# The macros of a component package. Reached by
#   find_package(OROCOS-RTT REQUIRED)
#   include(${OROCOS-RTT_USE_FILE_PATH}/UseOROCOS-RTT.cmake)
#
#   orocos_component(name src…)      component library          lib/orocos/<target>/<project>
#   orocos_component(name STATIC src…)   components of the programs that link the library   lib
#   orocos_typekit(name src…)        hand-written typekit       …/types
#   orocos_plugin / orocos_service   plugin                     …/plugins
#   orocos_library(name src…)        ordinary shared library    lib
#   orocos_executable(name src…)     program                    bin
#       all of these: [INSTALL dir] [VERSION v] [EXPORT set] [INCLUDES DESTINATION dir]
#   orocos_configure_executable(target…)
#   orocos_typegen_headers(header…)  typekit made by typegen    …/types
#   orocos_typegen_headers(header… COMMITTED folder)   of sources that typegen wrote before
#   orocos_generate_components(manifest.xml)
#   orocos_install_headers(…) orocos_generate_package(…) orocos_uninstall_target()
#   orocos_find_package(pkg…) orocos_use_package(pkg…) orocos_get_manifest_deps(variable)
#   orocos_add_include_directories(target …) orocos_add_compile_flags(target …)
#   orocos_link_whole(target …)      as STATIC, for static libraries made by add_library()
#   orocos_add_link_flags(target …) orocos_set_install_rpath(target …)
#
# Policies are fixed here, so that the macros behave the same for all versions that packages ask for.
cmake_policy(PUSH)
cmake_policy(VERSION 3.16...3.25)

# The config of another package may include this file without find_package(OROCOS-RTT).
if(NOT OROCOS-RTT_FOUND)
  find_package(OROCOS-RTT REQUIRED QUIET PATHS ${CMAKE_CURRENT_LIST_DIR} NO_DEFAULT_PATH)
endif()

include(GNUInstallDirs)
include(${CMAKE_CURRENT_LIST_DIR}/OrocosConfigure.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/OrocosTargets.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/OrocosDependencies.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/OrocosGenerate.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/OrocosTypegen.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/OrocosCatkin.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/OrocosCorba.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/OrocosExport.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/OrocosPackage.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/OrocosHelpers.cmake)

_oro_note_directory()
if(NOT USE_OROCOS_RTT)
  set(USE_OROCOS_RTT TRUE)
  add_definitions(${OROCOS-RTT_DEFINITIONS})
  if(NOT DEFINED OROCOS_SUFFIX)
    set(OROCOS_SUFFIX /${OROCOS_TARGET})
  endif()
  option(OROCOS_NO_AUTO_LINKING "Do not link targets with the libraries of used packages" OFF)
  _oro_forget_last_run()

  # The word "orocos" means the prefix of the toolchain; anything else is a path.
  if(INSTALL_PATH AND NOT ORO_DEFAULT_INSTALL_PREFIX)
    set(ORO_DEFAULT_INSTALL_PREFIX ${INSTALL_PATH})
  endif()
  if(ORO_DEFAULT_INSTALL_PREFIX STREQUAL "orocos")
    set(CMAKE_INSTALL_PREFIX ${OROCOS-RTT_PATH} CACHE PATH "Install prefix" FORCE)
  elseif(ORO_DEFAULT_INSTALL_PREFIX)
    set(CMAKE_INSTALL_PREFIX ${ORO_DEFAULT_INSTALL_PREFIX} CACHE PATH "Install prefix" FORCE)
  endif()
endif()

# Once for each project, because the first one in a workspace may have included this file for all.
if(NOT "${_oro_set_up}" STREQUAL "${PROJECT_SOURCE_DIR}")
  set(_oro_set_up "${PROJECT_SOURCE_DIR}")
  _oro_choose_flavour()
  _oro_set_output_directories()
  orocos_get_manifest_deps(_oro_manifest_deps)
  if(_oro_manifest_deps)
    _oro_use_manifest_packages(${_oro_manifest_deps})
  endif()
endif()

cmake_policy(POP)
