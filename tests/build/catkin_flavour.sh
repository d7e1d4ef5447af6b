#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# A package that is built as catkin does: what is to be loaded lies in the devel space, whose pkg-config file serves packages
# that are configured on their own; with a stand-in for catkin's own files, and without catkin, be it installed or not. The
# first python3 on PATH has no catkin_pkg, as those of pyenv and conda have none.
source "$(dirname "$0")/package_test.sh"
mkdir -p "$work/arm/include/arm" "$work/hand" "$work/prefix/share/catkin/cmake" "$work/bin" "$work/modules/catkin_pkg"
cd "$work"
printf '#!/bin/sh\nexec /usr/bin/python3 -I -S "$@"\n' > bin/python3
chmod +x bin/python3
touch modules/catkin_pkg/__init__.py  # what /usr/bin/python3 has, wherever this runs
export PATH=$work/bin:$PATH PYTHONPATH=$work/modules
! python3 -c 'import catkin_pkg' 2> b.log || fail "the first python3 has catkin_pkg"
without=-DCMAKE_DISABLE_FIND_PACKAGE_catkin=ON
echo 'int armReach();' > arm/include/arm/arm.hpp
echo 'int armReach() { return 41; }' > arm/arm.cpp
printf '#include <arm/arm.hpp>\nint main() { return armReach() - 41; }\n' > hand/main.cpp
echo '<package><name>arm</name><version>1.2.3</version><buildtool_depend>catkin</buildtool_depend><build_depend>rtt</build_depend></package>' > arm/package.xml
echo '<package><name>hand</name><version>1.0.0</version><build_depend>arm</build_depend></package>' > hand/package.xml
cat > arm/CMakeLists.txt << 'TXT'
cmake_minimum_required(VERSION 2.8.3)
project(arm)
find_package(catkin QUIET)
find_package(OROCOS-RTT REQUIRED)
include(${OROCOS-RTT_USE_FILE_PATH}/UseOROCOS-RTT.cmake)
include_directories(include)
orocos_library(arm-support arm.cpp)
orocos_component(arm arm.cpp)
orocos_plugin(arm-plugin arm.cpp)
orocos_install_headers(DIRECTORY include/arm/)
orocos_generate_package(INCLUDE_DIRS include)
message(STATUS "output ${ORO_COMPONENT_OUTPUT_DIRECTORY}")
TXT
cat > hand/CMakeLists.txt << 'TXT'
cmake_minimum_required(VERSION 2.8.3)
project(hand)
find_package(OROCOS-RTT REQUIRED)
include(${OROCOS-RTT_USE_FILE_PATH}/UseOROCOS-RTT.cmake)
message(STATUS "uses ${USE_OROCOS_PACKAGES}")
orocos_executable(hand main.cpp)
TXT
build() { # source devel option…
  local source=$1
  shift
  rm -rf "b_$source"
  cmake -S "$source" -B "b_$source" -Wno-dev -Wno-deprecated -DCMAKE_PREFIX_PATH="$prefix;$work/prefix" \
    -DCMAKE_INSTALL_PREFIX="$work/inst" "$@" > b.log 2>&1 && cmake --build "b_$source" > build.log 2>&1 || { cat b.log build.log; fail "$source"; }
}

# Told by CATKIN_DEVEL_PREFIX and package.xml.
build arm -DCATKIN_DEVEL_PREFIX="$work/devel" $without
expect_text b.log "output $work/devel/lib/orocos/gnulinux/arm"
expect_file devel/lib/orocos/gnulinux/arm/libarm-gnulinux.so
expect_file devel/lib/orocos/gnulinux/arm/plugins/libarm-plugin-gnulinux.so
pc=devel/lib/pkgconfig/arm-gnulinux.pc
expect_text $pc 'Version: 1.2.3'
expect_text $pc "-I$work/arm/include"
expect_text $pc "-L$work/devel/lib/orocos/gnulinux/arm/plugins -larm-plugin-gnulinux"
# Another package of the same devel space takes the first from there, as its package.xml asks.
build hand -DCATKIN_DEVEL_PREFIX="$work/devel" $without
expect_text b.log 'uses arm'
b_hand/hand-gnulinux || fail "hand, of the devel space"
# What is installed is as ever.
cmake --install b_arm > b.log
expect_file inst/lib/orocos/gnulinux/arm/libarm-gnulinux.so
expect_file inst/lib/cmake/arm/arm-config.cmake
! grep -r "$work/devel" inst/lib/cmake inst/lib/pkgconfig || fail "the installation names the devel space"

# By the variable alone, and not.
build arm -DORO_USE_CATKIN=ON $without
expect_text b.log "ORO_USE_CATKIN without catkin: the devel space is $work/b_arm/devel"
expect_file b_arm/devel/lib/orocos/gnulinux/arm/libarm-gnulinux.so
build arm -DCATKIN_DEVEL_PREFIX="$work/devel" -DORO_USE_CATKIN=OFF $without
expect_text b.log "output $work/b_arm/orocos/gnulinux/arm"
rm arm/package.xml
build arm -DCATKIN_DEVEL_PREFIX="$work/devel" $without
expect_text b.log "output $work/b_arm/orocos/gnulinux/arm"

# Where catkin is, every package calls catkin_package(); those that do not, have it called, and find_package() is catkin's.
echo '<package><name>arm</name><version>1.2.3</version></package>' > arm/package.xml
cat > prefix/share/catkin/cmake/catkinConfig.cmake << TXT
set(CATKIN_DEVEL_PREFIX $work/devel2)
macro(catkin_package)
  set(\${PROJECT_NAME}_CATKIN_PACKAGE TRUE)
  message(STATUS "catkin_package(\${ARGN})")
endmacro()
TXT
rm -rf inst
build arm
expect_text b.log 'catkin_package()'
expect_file devel2/lib/orocos/gnulinux/arm/libarm-gnulinux.so
cmake --install b_arm > b.log
[ ! -e inst/lib/cmake/arm ] || fail "two configs of one package"
sed -i 's/^include_directories/catkin_package(LIBRARIES arm)\n&/' arm/CMakeLists.txt
build arm
expect_text b.log 'catkin_package(LIBRARIES;arm)'
! grep -F 'catkin_package()' b.log || fail "catkin_package() was called twice"

# catkin asks a python3 for catkin_pkg: a package that has it found by the macros, or after them, has it ask one that can answer.
cat > prefix/share/catkin/cmake/catkinConfig.cmake << TXT
find_package(PythonInterp 3 REQUIRED)
execute_process(COMMAND \${PYTHON_EXECUTABLE} -c "import catkin_pkg" RESULT_VARIABLE status)
if(NOT status STREQUAL "0")
  message(FATAL_ERROR "\${PYTHON_EXECUTABLE} has no catkin_pkg")
endif()
message(STATUS "catkin uses \${PYTHON_EXECUTABLE}")
set(CATKIN_DEVEL_PREFIX $work/devel2)
TXT
sed -i '/^find_package(catkin/d; /^catkin_package/d' arm/CMakeLists.txt
build arm -DORO_USE_CATKIN=ON
expect_text b.log 'catkin uses /usr/bin/python3'
expect_file devel2/lib/orocos/gnulinux/arm/libarm-gnulinux.so
sed -i 's/^include_directories/find_package(catkin REQUIRED)\n&/' arm/CMakeLists.txt
echo '<package><name>arm</name><version>1.2.3</version><buildtool_depend>catkin</buildtool_depend></package>' > arm/package.xml
build arm
expect_text b.log 'catkin uses /usr/bin/python3'
# What the user says stands.
ln -s /usr/bin/python3 bin/mine
build arm -DPYTHON_EXECUTABLE="$work/bin/mine"
expect_text b.log "catkin uses $work/bin/mine"
# Where no python3 has it, what to pass is said.
sed -i '/^find_package(catkin/d' arm/CMakeLists.txt
echo 'raise ImportError' > modules/catkin_pkg/__init__.py
build arm -DORO_USE_CATKIN=ON $without
expect_text b.log 'pass -DPYTHON_EXECUTABLE=<it>'
