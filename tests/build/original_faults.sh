#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# What goes wrong with the macros of the original toolchain: lists that sub-directories lose, plugins that the pkg-config file
# does not name, libraries linked twice, and configured builds that do not notice what has changed.
source "$(dirname "$0")/package_test.sh"
cd "$work"
macros='find_package(OROCOS-RTT REQUIRED)
include(${OROCOS-RTT_USE_FILE_PATH}/UseOROCOS-RTT.cmake)'

# Lists, and plugins in the pkg-config file, from two levels of directories and from the package itself.
mkdir -p lists/src/deep
echo 'int one() { return 1; }' > lists/one.cpp
cat > lists/CMakeLists.txt << TXT
cmake_minimum_required(VERSION 2.8.3)
project(lists)
$macros
orocos_component(top one.cpp)
add_subdirectory(src)
# As packages do that make a library without the macros.
set(OROCOS_DEFINED_TYPES "\${OROCOS_DEFINED_TYPES} -lby-hand-\${OROCOS_TARGET}")
message(STATUS "comps \${OROCOS_DEFINED_COMPS} libs \${OROCOS_DEFINED_LIBS} plugins \${OROCOS_DEFINED_PLUGINS}")
message(STATUS "exported \${lists_EXPORTED_LIBRARIES}")
orocos_generate_package()
TXT
cat > lists/src/CMakeLists.txt << 'TXT'
orocos_component(middle ../one.cpp)
orocos_library(support ../one.cpp)
add_subdirectory(deep)
message(STATUS "middle knows ${OROCOS_DEFINED_PLUGINS}")
TXT
printf 'orocos_plugin(bottom-plugin ../../one.cpp)\norocos_service(bottom-service ../../one.cpp)\norocos_typekit(bottom-types ../../one.cpp)\n' > lists/src/deep/CMakeLists.txt
build_package lists b inst
cmake b > b.log
expect_text b.log 'middle knows -lbottom-plugin-gnulinux;-lbottom-service-gnulinux'
expect_text b.log 'comps -ltop-gnulinux;-lmiddle-gnulinux libs -lsupport-gnulinux plugins -lbottom-plugin-gnulinux;-lbottom-service-gnulinux'
expect_text b.log 'exported top;middle;support;bottom-plugin;bottom-service;bottom-types'
pc=inst/lib/pkgconfig/lists-gnulinux.pc
for library in '-L${orocos_libdir} -ltop' '-lmiddle' '-L${libdir} -lsupport' '-L${orocos_libdir}/plugins -lbottom-plugin' '-lbottom-service' \
               '-L${orocos_libdir}/types -lbottom-types' '-lby-hand'; do
  expect_text $pc "$library-gnulinux"
done
[ "$(grep -o -- '-lbottom-plugin' $pc | wc -l)" = 1 ] || fail "a plugin is named twice"

# A runtime that is used directly and by two packages of which one uses the other is linked once, and so is each of them.
mkdir twice
cat > twice/CMakeLists.txt << TXT
cmake_minimum_required(VERSION 3.16)
project(twice CXX)
$macros
orocos_use_package(lists)
orocos_use_package(lists orocos-rtt ocl-deployment)
orocos_library(twice twice.cpp)
target_link_libraries(twice \${USE_OROCOS_LIBRARIES} \${OROCOS-RTT_LIBRARIES})
TXT
cp lists/one.cpp twice/twice.cpp
sed -i 's/ -L[^ ]* -lby-hand-gnulinux//' $pc
export PKG_CONFIG_PATH=$work/inst/lib/pkgconfig
build_package twice b2 inst2 -G "Unix Makefiles"
for library in liborocos-rtt-gnulinux liborocos-ocl-deployment libmiddle libsupport; do
  [ "$(grep -oE "$library[^ ]*" b2/CMakeFiles/twice.dir/link.txt | wc -l)" = 1 ] || { cat b2/CMakeFiles/twice.dir/link.txt; fail "$library is not linked once"; }
done
readelf -d inst2/lib/libtwice-gnulinux.so > twice.elf
! grep RUNPATH twice.elf | grep -F -e "$work/b" || fail "the run path names a build folder"

# A build notices that a package it uses was installed anew, that package.xml asks for another, and that a package of the
# workspace has gone.
mkdir -p stale/first stale/second
cat > stale/CMakeLists.txt << TXT
cmake_minimum_required(VERSION 3.16)
project(stale CXX)
$macros
option(WITH_FIRST "the first package" ON)
if(WITH_FIRST)
  add_subdirectory(first)
endif()
add_subdirectory(second)
TXT
printf 'project(first CXX)\n%s\norocos_library(first ../one.cpp)\norocos_generate_package()\n' "$macros" > stale/first/CMakeLists.txt
cat > stale/second/CMakeLists.txt << TXT
project(second CXX)
$macros
orocos_use_package(first)
orocos_use_package(lists)
message(STATUS "second: first '\${first_FOUND}' '\${first-gnulinux_EXPORTED_LIBRARIES}' lists \${lists_VERSION} uses \${USE_OROCOS_PACKAGES}")
orocos_library(second ../one.cpp)
TXT
cp lists/one.cpp stale
xml() { echo "<package><name>second</name><version>1.0</version>$1</package>" > stale/second/package.xml; }
xml ''
for generator in Ninja "Unix Makefiles"; do
  rm -rf b3
  cmake -S stale -B b3 -G "$generator" -DCMAKE_PREFIX_PATH="$prefix" > b3.log 2>&1 || { cat b3.log; fail "stale"; }
  expect_text b3.log "second: first 'TRUE' 'first' lists 1.0 uses first;lists"
  again() { cmake --build b3 > b3.log 2>&1 || { cat b3.log; fail "$generator: build $1"; }; }
  again "at first"
  again "without a change"
  ! grep 'second: first' b3.log || fail "$generator: configured without a change"
  sleep 1.1
  sed -i 's/^Version: .*/Version: 1.7/' $pc
  again "with lists installed anew"
  expect_text b3.log "lists 1.7 uses"
  sleep 1.1
  xml '<build_depend>rtt-scripting</build_depend>'
  again "with another dependency"
  expect_text b3.log "uses rtt-scripting;first;lists"
  cmake b3 -DWITH_FIRST=OFF > b3.log
  expect_text b3.log "second: first '' '' lists 1.7"
  sed -i 's/^Version: .*/Version: 1.0/' $pc
  xml ''
done
