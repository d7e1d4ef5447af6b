#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Two packages in one CMake run, the second made of the first one's types and libraries, which are not installed yet.
source "$(dirname "$0")/package_test.sh"
here=$(cd "$(dirname "$0")" && pwd)

cp -r "$here/packages/workspace" "$work"
build_package "$work/workspace" "$work/b" "$work/inst"
expect_file "$work/inst/lib/orocos/gnulinux/upper/types/libupper-typekit-gnulinux.so"

# Moved, without a hint where anything is.
mv "$work/inst" "$work/moved"
[ "$("$work/moved/bin/upper-main-gnulinux")" = "lower 21, upper 42" ] || fail "upper-main after the move"

# The typekit as an imported target, in plain CMake.
mkdir "$work/plain"
cat > "$work/plain/CMakeLists.txt" << 'TXT'
cmake_minimum_required(VERSION 3.16)
project(plain CXX)
find_package(upper REQUIRED COMPONENTS upper-typekit)
add_executable(plain main.cpp)
target_link_libraries(plain PRIVATE upper::upper-typekit)
TXT
cat > "$work/plain/main.cpp" << 'TXT'
#include <upper/typekit/Types.hpp>
#include <rtt/Property.hpp>
int main() { return RTT::Property<upper::Pair>("p", "").get().first.values.empty() ? 0 : 1; }
TXT
cmake -S "$work/plain" -B "$work/b2" -DCMAKE_PREFIX_PATH="$prefix;$work/moved" > "$work/b2.log" 2>&1 &&
  cmake --build "$work/b2" > "$work/b2.log" 2>&1 || { cat "$work/b2.log"; fail "plain"; }
"$work/b2/plain" || fail "a program with an imported typekit"

# A workspace that includes the macros once, for all of its projects: each has its own folders and dependencies.
mkdir -p "$work/once/one" "$work/once/two"
echo 'int one() { return 1; }' > "$work/once/one.cpp"
cat > "$work/once/CMakeLists.txt" << 'TXT'
cmake_minimum_required(VERSION 3.16)
project(once CXX)
find_package(OROCOS-RTT REQUIRED)
include(${OROCOS-RTT_USE_FILE_PATH}/UseOROCOS-RTT.cmake)
add_subdirectory(one)
add_subdirectory(two)
TXT
printf 'project(one)\norocos_component(one ../one.cpp)\norocos_generate_package()\n' > "$work/once/one/CMakeLists.txt"
cat > "$work/once/two/CMakeLists.txt" << 'TXT'
project(two)
include(${OROCOS-RTT_USE_FILE_PATH}/UseOROCOS-RTT.cmake)
message(STATUS "two uses ${USE_OROCOS_PACKAGES} of ${one-gnulinux_EXPORTED_LIBRARY_DIRS}")
orocos_component(two ../one.cpp)
add_library(by-name SHARED ../one.cpp)
target_link_libraries(by-name PRIVATE one::one)
orocos_generate_package()
TXT
echo '<package><depend>one</depend></package>' > "$work/once/two/package.xml"
build_package "$work/once" "$work/b3" "$work/inst3"
expect_file "$work/b3/one/orocos/gnulinux/one/libone-gnulinux.so"
expect_file "$work/b3/two/orocos/gnulinux/two/libtwo-gnulinux.so"
expect_file "$work/inst3/lib/orocos/gnulinux/two/libtwo-gnulinux.so"
cmake "$work/b3" > "$work/b3.log"
expect_text "$work/b3.log" "two uses one of $work/b3/one/orocos/gnulinux/one"
