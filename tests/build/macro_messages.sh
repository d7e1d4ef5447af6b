#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# What the macros say to calls that make no sense. Nothing is compiled; one build folder serves all, its cache makes it quick.
source "$(dirname "$0")/package_test.sh"
mkdir -p "$work/pkg/sub" "$work/pkg/empty"
cd "$work"
echo 'int one() { return 1; }' > pkg/one.cpp
: > pkg/sub/CMakeLists.txt
calls() { # text after the macros are there
  printf 'cmake_minimum_required(VERSION 3.16)\nproject(pkg CXX)\nfind_package(OROCOS-RTT REQUIRED)\ninclude(${OROCOS-RTT_USE_FILE_PATH}/UseOROCOS-RTT.cmake)\n%s\n' "$1" > pkg/CMakeLists.txt
}
configure() {
  local status=0
  cmake -S pkg -B b -Wno-dev -DCMAKE_BUILD_TYPE=Debug -DCMAKE_PREFIX_PATH="$prefix" > b.log 2>&1 || status=$?
  tr -s ' \n' ' ' < b.log > b.line
  return $status
}
refused() { # message calls
  calls "$2"
  ! configure || { cat b.log; fail "accepted: $2"; }
  expect_text b.line "$1"
}
warned() { # message calls
  calls "$2"
  configure || { cat b.log; fail "refused: $2"; }
  expect_text b.line "$1"
}

refused 'orocos_component(arm): no source files given, expected orocos_component(name source…)' 'orocos_component(arm)'
refused 'orocos_plugin(arm): no source files given' 'orocos_service(arm VERSION 1.0)'
refused "orocos_library(arm): there is a target 'arm' already, made in $work/pkg;" 'orocos_component(arm one.cpp)
orocos_library(arm one.cpp)'
refused 'orocos_configure_executable(arn): there is no target of that name (yet); those made by the macros: arm, leg' \
  'orocos_library(arm one.cpp)
orocos_executable(leg one.cpp)
orocos_configure_executable(arn)'
refused 'orocos_add_compile_flags(arm): there is no target of that name (yet); the macros have made none in pkg yet' 'orocos_add_compile_flags(arm -Wall)'
refused 'orocos_add_link_flags(arm): there is no target' 'orocos_add_link_flags(arm -s)'
refused 'orocos_add_include_directories(arm): there is no target' 'orocos_add_include_directories(arm /usr)'
refused 'orocos_set_install_rpath(arm): there is no target' 'orocos_set_install_rpath(arm /usr)'
refused 'orocos_link_whole(): no target given' 'orocos_link_whole()'
refused 'orocos_configure_executable(orocos::orocos-rtt): this target is imported' 'orocos_configure_executable(orocos::orocos-rtt)'

refused 'orocos_use_package(): no package given' 'orocos_use_package(REQUIRED)'
refused "package rtt_scripting not found: no pkg-config module named any of: rtt_scripting-gnulinux, rtt_scripting (searched CMAKE_PREFIX_PATH, PKG_CONFIG_PATH and the toolchain); did you mean 'rtt-scripting'?" \
  'orocos_use_package(rtt_scripting REQUIRED)'
refused 'package nowhere not found: no pkg-config module named any of: nowhere-gnulinux (searched CMAKE_PREFIX_PATH, PKG_CONFIG_PATH and the toolchain); packages for gnulinux: fbsched, ocl, ocl-common, ocl-deployment, ocl-deployment-corba, ocl-helloworld, ocl-logging, ocl-lua, ocl-lua-tlsf, ocl-replay, ocl-reporting, ocl-reporting-mcap, and others package elsewhere not found' \
  'orocos_find_package(nowhere rtt-typekit elsewhere OROCOS_ONLY REQUIRED)'
warned 'orocos_use_package(): package nowhere not found' 'orocos_use_package(nowhere VERBOSE)'
warned "found [] []" 'orocos_use_package(nowhere)
message(STATUS "found [${nowhere_FOUND}] [${USE_OROCOS_PACKAGES}]")'
! grep -q Warning b.log || fail "a package that is not required is missed aloud"

# A package whose own dependencies are missing is there, but of no use.
mkdir -p "$work/halves/lib/pkgconfig"
printf 'Name: half\nDescription: half\nVersion: 1.0\nRequires: other-half\n' > "$work/halves/lib/pkgconfig/half-gnulinux.pc"
PKG_CONFIG_PATH=$work/halves/lib/pkgconfig warned "package half is there, but cannot be used: Package 'other-half', required by 'half-gnulinux', not found" 'orocos_use_package(half)'
refused "package half is there, but cannot be used: Package 'other-half', required by 'half-gnulinux', not found" "list(APPEND CMAKE_PREFIX_PATH $work/halves)
orocos_use_package(half REQUIRED)"

refused "a package 'pkg-gnulinux' was made already, in $work/pkg;" 'orocos_generate_package()
orocos_generate_package()'
warned "orocos_generate_package(): the package is named 'arm'; not understood: leg DEPEND rtt" 'orocos_generate_package(arm leg DEPEND rtt)'
warned "orocos_generate_package(): 'leg' was not made by a macro of the package" 'orocos_library(arm one.cpp)
orocos_generate_package(LIBRARY arm leg)'
warned 'made after orocos_generate_package(), which ought to be the last statement of a package, and so in no package: arm, leg' \
  'orocos_generate_package()
orocos_library(arm one.cpp)
orocos_component(leg one.cpp)'
warned "orocos_install_headers(): there is no 'arm.hpp' in $work/pkg; unless the build makes it, the installation will fail" 'orocos_install_headers(arm.hpp)'
warned "orocos_install_headers(): there is no 'include' in $work/pkg" 'orocos_install_headers(DIRECTORY include)'
warned 'the static library arm links the static library leg, which the package does not install; make it by orocos_library(leg STATIC …)' \
  'add_library(leg STATIC one.cpp)
orocos_library(arm STATIC one.cpp)
target_link_libraries(arm leg)
orocos_generate_package()'

# Directories of subdirs(), as old packages have them, are configured when that of the project has ended.
mkdir -p pkg/sub/below
printf '#pragma once\nstruct One { int a; };\n' > pkg/one.hpp
echo 'orocos_library(late ../one.cpp)
orocos_executable(program ../one.cpp)' > pkg/sub/CMakeLists.txt
warned 'and so in no package: late (directories of subdirs() come after all statements; add_subdirectory() does not)' 'subdirs(sub)
orocos_component(arm one.cpp)
target_link_libraries(arm late m)
orocos_generate_package()'
[ "$(grep -o 'in no package' b.line | wc -l)" = 1 ] || fail "told more than once"
targets=b/package-config/pkg/Debug/orocos-targets.cmake
grep -q 'INTERFACE_LINK_LIBRARIES.*;m"' $targets || fail "the libraries of arm"
! grep 'LIBRARIES.*late' $targets || fail "users of arm are told to link what is not installed"
printf '%s\n' 'subdirs(below)' 'orocos_typegen_headers(../one.hpp)' 'orocos_library(leg ../one.cpp)' 'orocos_generate_package()' > pkg/sub/CMakeLists.txt
printf '%s\n' 'orocos_library(foot ../../one.cpp)' 'orocos_generate_package()' > pkg/sub/below/CMakeLists.txt
calls 'subdirs(sub)'
configure || { cat b.log; fail "a package in directories of subdirs()"; }
! grep -q 'in no package' b.line || { cat b.log; fail "a package below another one is told to have none"; }

# Generators have one call in a project.
echo '<package name="pkg"><component class="pkg::One"/></package>' > pkg/pkg.xml
printf '#pragma once\nstruct One { int a; };\n' > pkg/one.hpp
refused 'orocos_generate_components(pkg.xml): called a second time in project pkg; a project has one manifest, with all of its components' 'orocos_generate_components(pkg.xml)
orocos_generate_components(pkg.xml)'
refused "orocos_generate_components(): no file 'arm.xml' in $work/pkg" 'orocos_generate_components(arm.xml)'
refused 'orocos_typegen_headers(): called a second time in project pkg; list all headers in one call' 'orocos_typegen_headers(one.hpp)
orocos_typegen_headers(one.hpp)'
refused "orocos_typegen_headers(): no file 'two.hpp' in $work/pkg" 'orocos_typegen_headers(two.hpp)'

# In a workspace, the package that is used comes first.
printf 'project(sub)\norocos_generate_package()\n' > pkg/sub/CMakeLists.txt
warned 'package sub comes after pkg, which asked for it and did not find it: in the workspace, the directory of sub has to be added first' \
  'orocos_use_package(sub)
add_subdirectory(sub)'
: > pkg/sub/CMakeLists.txt

refused "no such plugins for gnulinux: rtt-transport-ros, rtt-elsewhere (searched: $prefix/lib/orocos/gnulinux/plugins, " \
  'find_package(OROCOS-RTT REQUIRED rtt-scripting rtt-transport-ros rtt-elsewhere)'
refused "no such parts for gnulinux: ocl-vision; $prefix has: deployment-corba, deployment, taskbrowser, common, helloworld, logging, lua, lua-tlsf, replay, reporting, reporting-mcap, reporting-netcdf, timer" \
  'find_package(OROCOS-OCL REQUIRED COMPONENTS deployment ocl-vision)'
# The environment goes first, and says so.
calls ''
cmake -S pkg -B b -Wno-dev -DOROCOS_TARGET=lxrt > b.log 2>&1 || { cat b.log; fail "another target in the cache"; }
expect_text b.log "OROCOS_TARGET is 'gnulinux', as the environment has it, instead of 'lxrt'"
export OROCOS_TARGET=xenomai
refused "OROCOS_TARGET is 'xenomai', but the toolchain in $prefix was built for 'gnulinux'" ''
