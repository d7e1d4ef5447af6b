#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# What a package tells others in its pkg-config file, and what it takes from package.xml and from installed packages.
source "$(dirname "$0")/package_test.sh"

mkdir "$work/told" "$work/asks" "$work/external"
cd "$work/told"
echo 'int a() { return 1; }' > a.cpp
echo '#pragma once' > told.hpp
cat > package.xml << 'XML'
<package>
  <name>told</name>
  <version>2.3.4</version>
  <!-- <build_depend>absent_one</build_depend> -->
  <build_depend>ocl</build_depend>
  <!-- a comment > with a bracket <depend>absent_two</depend>
  -->
</package>
XML
cat > CMakeLists.txt << TXT
cmake_minimum_required(VERSION 3.16)
project(told CXX)
find_package(OROCOS-RTT REQUIRED)
include(\${OROCOS-RTT_USE_FILE_PATH}/UseOROCOS-RTT.cmake)
orocos_get_manifest_deps(deps)
message(STATUS "deps: \${deps}; used: \${USE_OROCOS_PACKAGES}")
orocos_component(told a.cpp)
orocos_component(told-elsewhere a.cpp INSTALL lib/elsewhere)
orocos_install_headers(told.hpp DESTINATION include/orocos/own)
orocos_generate_package(INCLUDE_DIRS include $work/external)
orocos_library(told-second a.cpp)
orocos_generate_package(told-second-gnulinux)
TXT
build_package "$work/told" "$work/b" "$work/inst"
cmake "$work/b" > "$work/b.log"
expect_text "$work/b.log" 'deps: ocl; used: ocl'
expect_file "$work/inst/include/orocos/own/told.hpp"
pc=$work/inst/lib/pkgconfig/told-gnulinux.pc
expect_text "$pc" 'Version: 2.3.4'
expect_text "$pc" '-L${orocos_libdir} -ltold-gnulinux'
expect_text "$pc" '-L${libdir}/elsewhere/gnulinux -ltold-elsewhere-gnulinux'
expect_text "$pc" "-I$work/external"
! grep -q told-second "$pc" || fail "the first package lists a library of the second"
! grep -q elsewhere "$work/inst/lib/pkgconfig/told-second-gnulinux.pc" || fail "the second package lists a library of the first"

# Who asks for the package finds all of it, and after it is gone nothing of it.
cat > "$work/asks/CMakeLists.txt" << 'TXT'
cmake_minimum_required(VERSION 3.16)
project(asks CXX)
find_package(OROCOS-RTT REQUIRED)
include(${OROCOS-RTT_USE_FILE_PATH}/UseOROCOS-RTT.cmake)
orocos_use_package(told)
orocos_use_package(sigc++-2.0)
orocos_use_package(sigc++-2.0)
message(STATUS "found '${told_FOUND}' in '${told_INCLUDE_DIRS}': ${told_LIBRARIES}")
TXT
cmake -S "$work/asks" -B "$work/b2" -DCMAKE_PREFIX_PATH="$prefix;$work/inst" > "$work/b2.log" 2>&1 || { cat "$work/b2.log"; fail "told not usable"; }
expect_text "$work/b2.log" "found '1'"
expect_text "$work/b2.log" libtold-elsewhere-gnulinux.so
rm -r "$work/inst"
cmake "$work/b2" > "$work/b2.log" 2>&1 || { cat "$work/b2.log"; fail "configuring without told"; }
expect_text "$work/b2.log" "found '' in '': "
