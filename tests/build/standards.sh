#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Packages say in many ways which C++ they want: less than C++17 is raised, more is kept.
source "$(dirname "$0")/package_test.sh"

mkdir "$work/pkg"
cd "$work/pkg"
cat > CMakeLists.txt << 'TXT'
cmake_minimum_required(VERSION 2.8.12)
project(standards CXX)
find_package(OROCOS-RTT REQUIRED)
include(${OROCOS-RTT_USE_FILE_PATH}/UseOROCOS-RTT.cmake)
TXT
printf '#if __cplusplus < WANTED\n#error "too old a standard"\n#endif\n' > check.cpp
cp check.cpp source.cpp
way() { # name wanted text
  mkdir "$1"
  printf '%s\n' "$3" > "$1/CMakeLists.txt"
  printf 'target_compile_definitions(%s PRIVATE WANTED=%s)\n' "$1" "$2" >> "$1/CMakeLists.txt"
  echo "add_subdirectory($1)" >> CMakeLists.txt
}
way none 201703L 'orocos_library(none ../check.cpp)'
way variable 201703L 'set(CMAKE_CXX_STANDARD 11)
orocos_library(variable ../check.cpp)'
way definitions 201703L 'add_definitions(-std=c++11)
orocos_library(definitions ../check.cpp)'
way options 201703L 'add_compile_options(-std=c++0x)
orocos_library(options ../check.cpp)'
way flags 201703L 'set(CMAKE_CXX_FLAGS "${CMAKE_CXX_FLAGS} -std=c++14")
orocos_library(flags ../check.cpp)'
way late_flags 201703L 'orocos_library(late_flags ../check.cpp)
set(CMAKE_CXX_FLAGS "${CMAKE_CXX_FLAGS} -std=c++11")'
way build_type 201703L 'set(CMAKE_CXX_FLAGS_RELEASE "-O2 -std=c++11")
orocos_library(build_type ../check.cpp)'
way property 201703L 'orocos_library(property ../check.cpp)
set_target_properties(property PROPERTIES COMPILE_FLAGS "-std=c++11")'
way target_options 201703L 'orocos_library(target_options ../check.cpp)
target_compile_options(target_options PRIVATE -std=gnu++11)'
way macro 201703L 'orocos_executable(macro ../check.cpp ../main.cpp)
orocos_add_compile_flags(macro -std=c++11)'
way required 201703L 'set(CMAKE_CXX_STANDARD 14)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
orocos_library(required ../check.cpp)'
way first_flag 201703L 'set(CMAKE_CXX_FLAGS "--std=c++11 ${CMAKE_CXX_FLAGS}")
orocos_component(first_flag ../check.cpp)'
way many_words 201703L 'add_definitions(-DSOME "-std=c++0x -Wall")
orocos_service(many_words ../check.cpp)'
way conditional 201703L 'add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-std=c++14>)
orocos_typekit(conditional ../check.cpp)'
way target_standard 201703L 'orocos_library(target_standard ../check.cpp)
set_target_properties(target_standard PROPERTIES CXX_STANDARD 11)'
way features 201703L 'orocos_library(features ../check.cpp)
target_compile_features(features PRIVATE cxx_std_11)'
way source 201703L 'orocos_library(source ../source.cpp)
set_source_files_properties(../source.cpp PROPERTIES COMPILE_FLAGS "-std=c++11 -Wall")'
way linked 201703L 'add_library(old_one INTERFACE)
target_compile_options(old_one INTERFACE -std=c++11)
orocos_library(linked ../check.cpp)
target_link_libraries(linked old_one)'
way configured 201703L 'add_definitions(-std=c++11)
add_executable(configured ../check.cpp ../main.cpp)
orocos_configure_executable(configured)'
way static 201703L 'add_compile_options(-std=c++11)
orocos_component(static STATIC ../check.cpp)'
way newer 202002L 'add_definitions(-std=c++20)
orocos_library(newer ../check.cpp)'
way newer_variable 202002L 'set(CMAKE_CXX_STANDARD 20)
orocos_library(newer_variable ../check.cpp)'
echo 'int main() {}' > main.cpp
build_package "$work/pkg" "$work/b" "$work/inst" -DCMAKE_BUILD_TYPE=Release
