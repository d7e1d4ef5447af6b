#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Packages that are built as rosbuild did, in their source folders: others find them there, below ROS_PACKAGE_PATH, to build
# with and to load. ROS is not there; the packages are told by the variable, or by a stand-in for rosbuild's own macro.
source "$(dirname "$0")/package_test.sh"
export ROS_PACKAGE_PATH=$work/elsewhere:$work/ws
mkdir -p "$work/ws/arm/include/arm" "$work/ws/stack/hand"
cd "$work/ws"
echo 'int armReach();' > arm/include/arm/arm.hpp
echo 'int armReach() { return 41; }' > arm/arm.cpp
printf '#include <rtt/Component.hpp>\nstruct Arm : RTT::TaskContext { explicit Arm(const std::string& n) : TaskContext(n) {} };\nORO_CREATE_COMPONENT(Arm)\n' > arm/component.cpp
printf '#include <rtt/plugin/ServicePlugin.hpp>\nstruct Clock : RTT::Service { explicit Clock(RTT::TaskContext* o) : Service("clock", o) {} };\nORO_SERVICE_NAMED_PLUGIN(Clock, "clock")\n' > arm/plugin.cpp
printf '#include <arm/include/arm/arm.hpp>\n#include <arm/arm.hpp>\nint main() { return armReach() - 41; }\n' > stack/hand/main.cpp
echo '<package><description>d</description><depend package="rtt"/><depend package="ocl_of_old"/></package>' > arm/manifest.xml
echo '<package><!-- <depend package="leg"/> --><depend package="arm"/></package>' > stack/hand/manifest.xml
cat > arm/CMakeLists.txt << 'TXT'
cmake_minimum_required(VERSION 2.8.3)
if(STAND_IN)
  macro(rosbuild_init)
    project(arm)
  endmacro()
  rosbuild_init()
else()
  project(arm)
endif()
find_package(OROCOS-RTT REQUIRED)
include(${OROCOS-RTT_USE_FILE_PATH}/UseOROCOS-RTT.cmake)
set(LIBRARY_OUTPUT_PATH ${PROJECT_SOURCE_DIR}/lib)  # as roscreate-pkg wrote it
include_directories(include)
orocos_library(arm-support arm.cpp)
orocos_library(arm-static STATIC arm.cpp)
orocos_component(arm component.cpp)
orocos_plugin(arm-plugin plugin.cpp)
orocos_install_headers(DIRECTORY include/arm/)
orocos_generate_package(INCLUDE_DIRS include)
message(STATUS "output ${ORO_COMPONENT_OUTPUT_DIRECTORY} ${ORO_TYPEKIT_OUTPUT_DIRECTORY} ${ORO_PLUGIN_OUTPUT_DIRECTORY}")
TXT
cat > stack/hand/CMakeLists.txt << 'TXT'
cmake_minimum_required(VERSION 2.8.3)
project(hand)
find_package(OROCOS-RTT REQUIRED)
include(${OROCOS-RTT_USE_FILE_PATH}/UseOROCOS-RTT.cmake)
message(STATUS "uses ${USE_OROCOS_PACKAGES}")
orocos_executable(hand main.cpp)
TXT
build() { # source option…
  local source=$1
  shift
  build=$work/b_${source##*/}
  rm -rf "$build"
  cmake -S "$source" -B "$build" -Wno-dev -Wno-deprecated -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_INSTALL_PREFIX="$work/inst" \
    "$@" > "$work/b.log" 2>&1 && cmake --build "$build" > "$work/build.log" 2>&1 || { cat "$work/b.log" "$work/build.log"; fail "$source"; }
}
out=$work/ws/arm/lib/orocos/gnulinux/arm

build arm -DORO_USE_ROSBUILD=ON
expect_text "$work/b.log" "output $out $out/types $out/plugins"
expect_file "$out/libarm-gnulinux.so"
expect_file "$out/plugins/libarm-plugin-gnulinux.so"
expect_file arm/lib/libarm-support-gnulinux.so
expect_file arm/lib/libarm-static-gnulinux.a
expect_text arm/lib/pkgconfig/arm-gnulinux.pc "-I$work/ws/arm/include"
! grep -q Warning "$work/b.log" || { cat "$work/b.log"; fail "a warning"; }
# Another one takes it from there, by its manifest.xml, though not built as rosbuild does.
build stack/hand -DORO_USE_ROSBUILD=OFF
expect_text "$work/b.log" 'uses arm'
"$build/hand-gnulinux" || fail "hand"
# So do programs that load it.
printf 'import("arm")\nloadComponent("one", "Arm")\nloadService("one", "clock")\none.start()\n' > "$work/app.ops"
(cd "$work" && timeout 60 rttscript -s app.ops > run.log 2>&1) || { cat "$work/run.log"; fail "rttscript"; }

# Where there are both files, package.xml is for catkin.
echo '<package><name>hand</name><version>1.0.0</version></package>' > stack/hand/package.xml
build stack/hand -DORO_USE_ROSBUILD=ON
expect_text "$work/b.log" 'uses arm'
rm stack/hand/package.xml

# What is installed is as ever.
build arm -DORO_USE_ROSBUILD=ON
cmake --install "$build" > "$work/b.log"
expect_file "$work/inst/lib/orocos/gnulinux/arm/libarm-gnulinux.so"
expect_file "$work/inst/lib/cmake/arm/arm-config.cmake"
! grep -r "$work/ws" "$work/inst/lib/cmake" "$work/inst/lib/pkgconfig" || fail "the installation names the source folder"

# By rosbuild's macro, unless the variable says otherwise.
rm -r arm/lib
build arm -DSTAND_IN=ON
expect_file "$out/libarm-gnulinux.so"
rm -r arm/lib
build arm -DSTAND_IN=ON -DORO_USE_ROSBUILD=OFF
expect_text "$work/b.log" "output $build/orocos/gnulinux/arm"
[ ! -e arm/lib/orocos ] || fail "something was built into the source folder"
