# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Debian packages of the toolchain, by cpack (./dev package): runtime, dev and tools, netcdf and ros where their libraries are
# installed, which together are a full installation.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME oroforge)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_VENDOR Oroforge)
set(CPACK_PACKAGE_CONTACT "Oroforge contributors <contributors@oroforge.invalid>")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL runtime dev tools)
if(TARGET ocl-netcdf-writer)
  list(APPEND CPACK_COMPONENTS_ALL netcdf)
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS oroforge-netcdf)
endif()
if(TARGET rtt_rostopic)
  list(APPEND CPACK_COMPONENTS_ALL ros)
endif()
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS
  ${PROJECT_BINARY_DIR}/lib ${PROJECT_BINARY_DIR}/${OROFORGE_PLUGIN_DIR}/plugins ${PROJECT_BINARY_DIR}/${OROFORGE_PLUGIN_DIR}/ocl)
set(same_version "(= ${PROJECT_VERSION}-1)")

set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "component runtime for real-time robot control
Components that exchange data through ports, call each other's operations
and run in threads of their own; the deployer, which loads and connects
them as a file says; scripts and property files as plugins.")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME oroforge-runtime)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/packaging/triggers CONTENT "activate-noawait ldconfig\n")
# Sets the target in login shells. Relative to /usr, because cpack would install to an absolute folder on this machine.
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/packaging/oroforge.sh CONTENT "# Which programs of Oroforge are meant, unless the user says another target.
export OROCOS_TARGET=\"\${OROCOS_TARGET:-@OROCOS_TARGET@}\"
" @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/packaging/oroforge.sh DESTINATION ../etc/profile.d COMPONENT runtime EXCLUDE_FROM_ALL)
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/packaging/conffiles CONTENT "/etc/profile.d/oroforge.sh\n")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA ${PROJECT_BINARY_DIR}/packaging/triggers ${PROJECT_BINARY_DIR}/packaging/conffiles)

set(CPACK_COMPONENT_DEV_DESCRIPTION "headers and CMake macros for components of Oroforge
What packages of components are compiled with: the headers of the runtime,
its CMake and pkg-config files and the macros that make components,
plugins, typekits and packages of them.")
set(CPACK_DEBIAN_DEV_PACKAGE_NAME oroforge-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "oroforge-runtime ${same_version}, cmake (>= 3.19), g++ | c++-compiler, libboost-dev, pkg-config")
if(TARGET orocos-ocl-logging)
  string(APPEND CPACK_DEBIAN_DEV_PACKAGE_DEPENDS ", liblog4cpp5-dev")
endif()
set(CPACK_DEBIAN_DEV_PACKAGE_RECOMMENDS "oroforge-tools ${same_version}, make | ninja-build")

set(CPACK_COMPONENT_TOOLS_DESCRIPTION "code generators for components of Oroforge
orocreate-pkg writes packages of components and what they need to be built;
typegen reads C++ headers and writes the typekits by which their types can
be used in ports, scripts and files.")
set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME oroforge-tools)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SECTION devel)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SHLIBDEPS ON)
# typegen needs clang's own headers.
set(CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS libclang-common-19-dev)
set(CPACK_DEBIAN_TOOLS_PACKAGE_RECOMMENDS "oroforge-dev ${same_version}")

set(CPACK_COMPONENT_ROS_DESCRIPTION "components of Oroforge as nodes of ROS 1
The packages rtt_ros and those around it: topics, services, parameters and
time of ROS for components, types for its messages, and launch files.")
set(CPACK_DEBIAN_ROS_PACKAGE_NAME oroforge-ros)
set(CPACK_DEBIAN_ROS_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_ROS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_ROS_PACKAGE_DEPENDS "oroforge-runtime ${same_version}")
set(CPACK_DEBIAN_ROS_PACKAGE_RECOMMENDS "oroforge-dev ${same_version}, libroscpp-dev, libstd-msgs-dev")

# A package of its own: libnetcdf brings 23 packages and 50 MB that a robot may do without.
set(CPACK_COMPONENT_NETCDF_DESCRIPTION "reports of Oroforge as NetCDF files
What the component type OCL::NetcdfReporting loads when it starts.")
set(CPACK_DEBIAN_NETCDF_PACKAGE_NAME oroforge-netcdf)
set(CPACK_DEBIAN_NETCDF_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_NETCDF_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_NETCDF_PACKAGE_DEPENDS "oroforge-runtime ${same_version}")

# Files that only Debian packages need.
set(folder ${PROJECT_BINARY_DIR}/packaging)
file(CONFIGURE OUTPUT ${folder}/copyright CONTENT "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: Oroforge

Files: *
Copyright: Oroforge contributors
License: Apache-2.0
 On Debian systems the text of this license is in /usr/share/common-licenses/Apache-2.0.
" @ONLY)
string(TIMESTAMP today "%a, %d %b %Y 00:00:00 +0000" UTC)
file(CONFIGURE OUTPUT ${folder}/changelog CONTENT "oroforge (${PROJECT_VERSION}-1) stable; urgency=medium

  * Made by cpack from the sources of this version.

 -- ${CPACK_PACKAGE_CONTACT}  ${today}
" @ONLY)
file(ARCHIVE_CREATE OUTPUT ${folder}/changelog.Debian.gz PATHS ${folder}/changelog FORMAT raw COMPRESSION GZip COMPRESSION_LEVEL 9)
foreach(part ${CPACK_COMPONENTS_ALL})
  install(FILES ${folder}/copyright ${folder}/changelog.Debian.gz DESTINATION share/doc/oroforge-${part}
    COMPONENT ${part} EXCLUDE_FROM_ALL)
endforeach()
include(CPack)
