#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# The ways in which packages find the toolchain and the variables they read, under the policies that they ask for, from the
# oldest on; the helpers that they call.
source "$(dirname "$0")/package_test.sh"
mkdir -p "$work/pkg/src" "$work/bridge/lib/cmake/bridge"
cd "$work"
echo 'int one() { return 1; }' > pkg/one.cpp
printf 'int one();\nint main() { return one() - 1; }\n' > pkg/main.cpp
configure() { cmake -S pkg -B b -DCMAKE_PREFIX_PATH="$prefix;$work/bridge" "$@" > b.log 2>&1 || { cat b.log; fail "configuring"; }; }
include='include(${OROCOS-RTT_USE_FILE_PATH}/UseOROCOS-RTT.cmake)'

# Each form of the census, with one build folder for all.
finds() { # call, what is then to be told
  printf 'cmake_minimum_required(VERSION 2.8.3)\nproject(pkg CXX)\n%s\nmessage(STATUS "told: %s")\norocos_component(pkg one.cpp)\n' "$1" "$2" > pkg/CMakeLists.txt
  configure -Wno-dev -Wno-deprecated -Drtt_PACKAGE_PATH="$prefix/share/rtt"
  expect_text b.log "told: $3"
}
hints='set(RTT_HINTS HINTS ${rtt_PACKAGE_PATH}/../..)'
finds "find_package(OROCOS-RTT REQUIRED)
$include" '${OROCOS-RTT_FOUND} ${OROCOS-RTT_VERSION_MAJOR}' '1 2'
finds "$hints
find_package(OROCOS-RTT REQUIRED \${RTT_HINTS})
include(\${OROCOS-RTT_USE_FILE})" '${OROCOS-RTT_PATH}' "$prefix"
finds "find_package(OROCOS-RTT QUIET)
$include" '${OROCOS-RTT_LIBRARIES} ${OROCOS-RTT_DEFINITIONS}' 'orocos::orocos-rtt -DOROCOS_TARGET=gnulinux'
finds "$hints
find_package(Orocos-RTT REQUIRED rtt-marshalling \${RTT_HINTS})
$include" '${OROCOS-RTT_RTT-MARSHALLING_LIBRARY}' "$prefix/lib/orocos/gnulinux/plugins/librtt-marshalling-gnulinux.so"
finds "find_package(OROCOS-RTT 2.0.0 COMPONENTS rtt-scripting rtt-marshalling)
$include" '${OROCOS-RTT_RTT-SCRIPTING_LIBRARY}' "$prefix/lib/orocos/gnulinux/plugins/librtt-scripting-gnulinux.so"
finds "find_package(OROCOS-RTT REQUIRED COMPONENTS rtt-scripting rtt-typekit)
$include" '${OROCOS-RTT_TYPEKIT_FOUND} ${OROCOS-RTT_CORBA_FOUND} ${OROCOS-RTT_MQUEUE_FOUND}' 'TRUE TRUE TRUE'
finds "find_package(OROCOS-RTT REQUIRED OPTIONAL_COMPONENTS rtt-transport-mqueue)
$include" '${OROCOS-RTT_RTT-TRANSPORT-MQUEUE_FOUND}' TRUE
finds "find_package(OROCOS-RTT EXACT)
$include" '${OROCOS-RTT_FOUND}' 1
finds "find_package(orocos-ocl REQUIRED)
$include" '${OROCOS-OCL_LIBRARIES}' 'orocos::orocos-ocl-deployment'
finds "find_package(OROCOS-OCL REQUIRED COMPONENTS deployment)
$include" '${OROCOS-OCL_DEPLOYMENT_FOUND} ${OROCOS-OCL_DEPLOYMENT_LIBRARY}' 'TRUE orocos::orocos-ocl-deployment'
# The installation is named by hand, or brought along by the config of another package.
finds "include($prefix/lib/cmake/orocos-rtt/UseOROCOS-RTT.cmake)" '${OROCOS_TARGET} ${OROCOS_SUFFIX}' 'gnulinux /gnulinux'
echo "include($prefix/lib/cmake/orocos-rtt/UseOROCOS-RTT.cmake)" > bridge/lib/cmake/bridge/bridge-config.cmake
finds 'find_package(bridge REQUIRED)' '${USE_OROCOS_RTT} ${OROCOS-RTT_FOUND}' 'TRUE 1'
# Output folders, whether or not the package says something about them.
finds "find_package(OROCOS-RTT REQUIRED)
$include" '${ORO_COMPONENT_OUTPUT_DIRECTORY} ${ORO_TYPEKIT_OUTPUT_DIRECTORY} ${ORO_PLUGIN_OUTPUT_DIRECTORY}' \
  "$work/b/orocos/gnulinux/pkg $work/b/orocos/gnulinux/pkg/types $work/b/orocos/gnulinux/pkg/plugins"
finds "set(CMAKE_LIBRARY_OUTPUT_DIRECTORY $work/libs)
find_package(OROCOS-RTT REQUIRED)
$include
set(ORO_COMPONENT_OUTPUT_DIRECTORY own)" '${ORO_PLUGIN_OUTPUT_DIRECTORY}' "$work/libs/orocos/gnulinux/pkg/plugins"
cmake --build b > b.log 2>&1 || { cat b.log; fail "build into a folder of its own"; }
expect_file b/own/libpkg-gnulinux.so

# Policies: no warning about any, and the same results under all.
for version in 2.4.6 2.6.3 2.8 2.8.3 3.5 3.25; do
  cat > pkg/CMakeLists.txt << TXT
cmake_minimum_required(VERSION $version)
project(pkg CXX)
find_package(OROCOS-RTT REQUIRED)
$include
orocos_library(pkg-support one.cpp)
orocos_use_package(ocl-deployment)
orocos_component(pkg-component one.cpp)
target_link_libraries(pkg-component pkg-support)
add_executable(pkg-plain main.cpp)
orocos_configure_executable(pkg-plain)
target_link_libraries(pkg-plain pkg-support)
orocos_executable(pkg-main main.cpp)
target_link_libraries(pkg-main PRIVATE pkg-support)
orocos_install_headers(one.cpp)
orocos_generate_package(INCLUDE_DIRS include)
TXT
  rm -rf b
  configure -Wno-deprecated
  ! grep -i warning b.log || { cat b.log; fail "cmake_minimum_required($version)"; }
  case $version in 2.4.6 | 3.25)
    cmake --build b > b.log 2>&1 || { cat b.log; fail "cmake_minimum_required($version)"; }
    b/pkg-plain && b/pkg-main-gnulinux || fail "cmake_minimum_required($version): programs" ;;
  esac
done

# Helpers, in a project of no language.
cat > pkg/CMakeLists.txt << TXT
cmake_minimum_required(VERSION 2.6.3)
project(pkg CXX)
find_package(OROCOS-RTT REQUIRED)
$include
macro(macro_of_a_package)
  oro_parse_arguments(ARG "INSTALL;DEPENDS" "OPTIONAL;FAST" \${ARGN})
endmacro()
macro_of_a_package(a.cpp b.cpp DEPENDS x FAST y INSTALL lib)
message(STATUS "parsed: '\${ARG_DEFAULT_ARGS}' '\${ARG_DEPENDS}' '\${ARG_INSTALL}' '\${ARG_OPTIONAL}' '\${ARG_FAST}'")
set(words a b "c d")
_orocos_list_to_string(text "\${words}")
_orocos_list_to_string(again words)
_orocos_list_to_string(none "")
message(STATUS "text: '\${text}' '\${again}' '\${none}'")
orocos_get_manifest_deps(deps)
message(STATUS "deps: \${deps}")
TXT
cat > pkg/manifest.xml << 'XML'
<package>
  <!-- <depend package="not_this"/> -->
  <depend package="rtt"/>
  <depend
     package='rtt-scripting' />
  <rosdep name="other"/>
  <depend package="sensors"/>
</package>
XML
configure -Wno-deprecated
expect_text b.log "parsed: 'a.cpp;b.cpp' 'x;y' 'lib' 'FALSE' 'TRUE'"
expect_text b.log "text: 'a b c d' 'a b c d' ''"
expect_text b.log 'deps: rtt-scripting;sensors'
