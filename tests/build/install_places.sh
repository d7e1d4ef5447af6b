#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Where packages are installed: ORO_DEFAULT_INSTALL_PREFIX, INSTALL arguments, stages below DESTDIR as distributions make them,
# and the way back.
source "$(dirname "$0")/package_test.sh"
trap 'rm -rf "${work%/a wörk folder}"' EXIT
work="$work/a wörk folder"
mkdir -p "$work/arm/include/arm" "$work/hand"
cd "$work"
echo 'int armReach();' > arm/include/arm/arm.hpp
echo 'int armReach() { return 41; }' > arm/arm.cpp
printf '#include <arm/arm.hpp>\nint hand() { return armReach(); }\n' > hand/hand.cpp
macros='find_package(OROCOS-RTT REQUIRED)
include(${OROCOS-RTT_USE_FILE_PATH}/UseOROCOS-RTT.cmake)'
cat > arm/CMakeLists.txt << TXT
cmake_minimum_required(VERSION 3.5)
project(arm CXX)
$macros
orocos_library(arm arm.cpp VERSION 1.2.0)
orocos_component(arm-component arm.cpp INSTALL lib/other)
orocos_plugin(arm-plugin arm.cpp INSTALL \${CMAKE_INSTALL_PREFIX}/lib/plug-ins)
orocos_install_headers(DIRECTORY include/arm/)
orocos_install_headers(FILES arm.cpp INSTALL share/arm)
orocos_generate_package(INCLUDE_DIRS \${CMAKE_INSTALL_PREFIX}/share/arm)
TXT
cat > hand/CMakeLists.txt << TXT
cmake_minimum_required(VERSION 3.5)
project(hand CXX)
$macros
orocos_use_package(arm REQUIRED)
orocos_component(hand hand.cpp)
orocos_generate_package(DEPENDS_TARGETS arm)
TXT
run() { "$@" > run.log 2>&1 || { cat run.log; fail "$*"; }; }

# The word "orocos" is the toolchain's prefix, the rest are paths; INSTALL_PATH is the old name.
run cmake -S arm -B b -DCMAKE_PREFIX_PATH="$prefix" -DORO_DEFAULT_INSTALL_PREFIX=orocos
expect_text b/CMakeCache.txt "CMAKE_INSTALL_PREFIX:PATH=$prefix"
run cmake -S arm -B b -DORO_DEFAULT_INSTALL_PREFIX="$work/elsewhere"
expect_text b/CMakeCache.txt "CMAKE_INSTALL_PREFIX:PATH=$work/elsewhere"
rm -rf b
run cmake -S arm -B b -DCMAKE_PREFIX_PATH="$prefix" -DINSTALL_PATH="$work/inst"
expect_text b/CMakeCache.txt "CMAKE_INSTALL_PREFIX:PATH=$work/inst"

# Nothing is there to remove before the first installation; afterwards all of it goes, whatever else is in the folders.
! cmake --build b --target uninstall > run.log 2>&1 || fail "something was removed"
tr -s ' \n' ' ' < run.log > run.line
expect_text run.line "nothing to remove: there is no $work/b/install_manifest.txt"
run cmake --build b
run cmake --install b
expect_file inst/lib/other/gnulinux/libarm-component-gnulinux.so
expect_file inst/lib/plug-ins/libarm-plugin-gnulinux.so
expect_file inst/lib/libarm-gnulinux.so.1.2.0
expect_file inst/share/arm/arm.cpp
expect_file inst/lib/orocos/gnulinux/arm
# Places that are named in full, but are of the prefix, move with it.
expect_text inst/lib/pkgconfig/arm-gnulinux.pc '-I${prefix}/share/arm'
expect_text inst/lib/cmake/arm/orocos-targets.cmake '"${_oro_prefix}/share/arm"'
! grep -rF "$work/inst" inst/lib/pkgconfig inst/lib/cmake || fail "the files above name the prefix"
touch inst/lib/pkgconfig/of_another.pc
mkdir -p inst/lib/orocos/gnulinux/other
run cmake --build b --target uninstall
find inst -not -type d -o -path '*/arm' -o -path '*/gnulinux/*' | sort > left
printf 'inst/lib/orocos/gnulinux/other\ninst/lib/pkgconfig/of_another.pc\n' | diff - left || fail "left after the removal"

# Staged, as a distribution builds its packages: the second is made against what the first has put below DESTDIR, and what is
# in its files is the final place.
rm -rf b inst
export DESTDIR=$work/stage
for package in arm hand; do
  run cmake -S $package -B b_$package -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_INSTALL_PREFIX=/opt/robot
  run cmake --build b_$package
  run cmake --install b_$package
done
expect_file stage/opt/robot/lib/orocos/gnulinux/hand/libhand-gnulinux.so
readelf -d stage/opt/robot/lib/orocos/gnulinux/hand/libhand-gnulinux.so > hand.elf
expect_text hand.elf 'libarm-gnulinux.so'
! grep -F "$work/stage" hand.elf || fail "the run path names the stage"
! grep -rF "$work/stage" stage/opt/robot/lib/cmake stage/opt/robot/lib/pkgconfig || fail "a file names the stage"
# Also where the module names its final place.
sed -i "s|^prefix=.*|prefix=/opt/robot|" stage/opt/robot/lib/pkgconfig/arm-gnulinux.pc
rm -r b_hand stage/opt/robot/lib/cmake
run cmake -S hand -B b_hand -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_INSTALL_PREFIX=/opt/robot
run cmake --build b_hand
run cmake --install b_hand
readelf -d stage/opt/robot/lib/orocos/gnulinux/hand/libhand-gnulinux.so > hand.elf
! grep -F "$work/stage" hand.elf || fail "the run path names the stage"
expect_text hand.elf '/opt/robot/lib'
run cmake --build b_arm --target uninstall
[ ! -e stage/opt/robot/lib/libarm-gnulinux.so ] || fail "DESTDIR was not heeded by the removal"
