#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# An installed package is found by find_package(), in plain CMake and by orocos_use_package(), with its libraries as imported
# targets; wherever it was moved to.
source "$(dirname "$0")/package_test.sh"
trap 'rm -rf "${work%/a wörk folder}"' EXIT
work="$work/a wörk folder"

mkdir -p "$work/arm/include/Arm-kit" "$work/arm/src" "$work/plain" "$work/hand" "$work/user"
cd "$work"
echo 'int armReach();' > arm/include/Arm-kit/arm.hpp
echo 'int part() { return 40; }' > arm/src/part.cpp
echo 'int armSupport() { return 1; }' > arm/src/support.cpp
printf 'int part();\nint armSupport();\nint armReach() { return part() + armSupport(); }\n' > arm/src/arm.cpp
printf 'int archived = 0;\nstruct Registers { Registers() { archived = 7; } } registers;\n' > arm/src/archive.cpp
cat > arm/CMakeLists.txt << 'TXT'
cmake_minimum_required(VERSION 3.16)
project(Arm-kit VERSION 1.4.2 LANGUAGES CXX)
find_package(OROCOS-RTT REQUIRED)
include(${OROCOS-RTT_USE_FILE_PATH}/UseOROCOS-RTT.cmake)
find_package(Threads REQUIRED)
add_library(part STATIC src/part.cpp)
set_target_properties(part PROPERTIES POSITION_INDEPENDENT_CODE ON)
add_subdirectory(src)
# Neither of these is installed, and install(EXPORT) would refuse both.
target_link_libraries(arm part arm-support Threads::Threads "$<BUILD_INTERFACE:m>")
target_include_directories(arm PUBLIC ${PROJECT_SOURCE_DIR}/src)
orocos_install_headers(DIRECTORY include/Arm-kit/)
add_executable(within src/within.cpp)
target_link_libraries(within PRIVATE Arm-kit::arm)
orocos_generate_package()
TXT
cat > arm/src/CMakeLists.txt << 'TXT'
orocos_library(arm-support support.cpp VERSION 1.4.2)
orocos_component(arm arm.cpp)
orocos_library(arm-archive STATIC archive.cpp)
TXT
printf '#include <Arm-kit/arm.hpp>\nint main() { return armReach(); }\n' > arm/src/within.cpp
build_package arm b1 inst
config=lib/cmake/Arm-kit
expect_file inst/$config/arm-kit-config.cmake
expect_file inst/$config/arm-kit-config-version.cmake
! grep -rF "$work" inst/lib/cmake inst/lib/pkgconfig || fail "the files above name a folder of this machine"
mv inst moved

# Plain CMake, both signatures of target_link_libraries().
printf '#include <Arm-kit/arm.hpp>\n#include <cstdio>\nextern int archived;\nint main() { return std::printf("reach %%d %%d\\n", armReach(), archived) < 0; }\n' > plain/main.cpp
plain() { # first line of the search
  cat > plain/CMakeLists.txt << TXT
cmake_minimum_required(VERSION 3.16)
project(plain CXX)
find_package($1)
message(STATUS "found \${Arm-kit_FOUND} \${Arm-kit_VERSION}: \${Arm-kit_LIBRARIES}")
if(Arm-kit_FOUND)
  add_executable(keyword main.cpp)
  target_link_libraries(keyword PRIVATE Arm-kit::arm Arm-kit::arm-archive)
  add_executable(signature main.cpp)
  target_link_libraries(signature Arm-kit::arm Arm-kit::arm-archive)
endif()
TXT
}
configure_plain() { cmake -S plain -B b2 -DCMAKE_PREFIX_PATH="$prefix;$work/moved" > b2.log 2>&1; }
plain 'Arm-kit 1.2 REQUIRED COMPONENTS arm arm-support'
configure_plain || { cat b2.log; fail "the package was not found"; }
expect_text b2.log 'found 1 1.4.2: Arm-kit::arm-support;Arm-kit::arm-archive;Arm-kit::arm'
cmake --build b2 > b2.log 2>&1 || { cat b2.log; fail "build with the imported targets"; }
for program in keyword signature; do
  [ "$(b2/$program)" = "reach 41 7" ] || fail "$program: $(b2/$program)"
done
plain 'Arm-kit 2.0'
configure_plain || fail "an optional package of another version ended the run"
expect_text b2.log 'found 0'
plain 'Arm-kit REQUIRED COMPONENTS arm elbow'
! configure_plain || fail "a library that is not there was found"
tr -s ' \n' ' ' < b2.log > b2.line
expect_text b2.line "it has no library 'elbow'; its targets: Arm-kit::arm-support;Arm-kit::arm-archive;Arm-kit::arm"

# A package of packages: what it links are targets, each once, and who finds it finds the first as well.
printf '#include <Arm-kit/arm.hpp>\nint hand() { return armReach() + 1; }\n' > hand/hand.cpp
printf 'int hand();\nint main() { return hand() == 42 ? 0 : 1; }\n' > hand/main.cpp
cp hand/main.cpp user
cat > hand/CMakeLists.txt << 'TXT'
cmake_minimum_required(VERSION 3.16)
project(hand CXX)
find_package(OROCOS-RTT REQUIRED)
include(${OROCOS-RTT_USE_FILE_PATH}/UseOROCOS-RTT.cmake)
orocos_use_package(Arm-kit REQUIRED)
message(STATUS "uses ${USE_OROCOS_LIBRARIES}; found ${Arm-kit_FOUND} ${Arm-kit_VERSION} ${Arm-kit_arm-gnulinux_LIBRARY}")
orocos_library(hand hand.cpp)
target_link_libraries(hand Arm-kit::arm)
orocos_executable(hand-main main.cpp)
target_link_libraries(hand-main PRIVATE hand)
orocos_generate_package(DEPENDS_TARGETS Arm-kit)
TXT
build_package hand b3 inst3 -G "Unix Makefiles" -DCMAKE_PREFIX_PATH="$prefix;$work/moved"
cmake b3 > b3.log
expect_text b3.log "uses Arm-kit::arm-support;Arm-kit::arm-archive;Arm-kit::arm;orocos::orocos-rtt; found 1 1.4.2 $work/moved/lib/orocos/gnulinux/Arm-kit/libarm-gnulinux.so"
for library in liborocos-rtt-gnulinux libarm-gnulinux libarm-support-gnulinux; do
  [ "$(grep -o "$library" b3/CMakeFiles/hand.dir/link.txt | wc -l)" = 1 ] || { cat b3/CMakeFiles/hand.dir/link.txt; fail "$library is not linked once"; }
done
inst3/bin/hand-main-gnulinux || fail "hand-main"
cat > user/CMakeLists.txt << 'TXT'
cmake_minimum_required(VERSION 3.16)
project(user CXX)
find_package(hand REQUIRED)
add_executable(user main.cpp)
target_link_libraries(user hand::hand)
TXT
mv inst3 hand_moved
cmake -S user -B b4 -DCMAKE_PREFIX_PATH="$prefix;$work/moved;$work/hand_moved" > b4.log 2>&1 && cmake --build b4 > b4.log 2>&1 || { cat b4.log; fail "a package of packages"; }
b4/user || fail "the program of the third package"

# By PKG_CONFIG_PATH alone, as environments of the original toolchain say it.
rm -rf b3 inst3
PKG_CONFIG_PATH=$work/moved/lib/pkgconfig build_package hand b3 inst3
PKG_CONFIG_PATH=$work/moved/lib/pkgconfig cmake b3 > b3.log
expect_text b3.log "uses Arm-kit::arm-support;"

# Without automatic linking a target has what it names.
rm -rf b3
build_package hand b3 inst3 -G "Unix Makefiles" -DCMAKE_PREFIX_PATH="$prefix;$work/moved" -DOROCOS_NO_AUTO_LINKING=ON
! grep -q libarm-archive b3/CMakeFiles/hand.dir/link.txt || fail "a library was linked that nobody named"
grep -q libarm-gnulinux b3/CMakeFiles/hand.dir/link.txt || fail "a library that was named was not linked"

# A package that exports targets itself, and one whose config would be in the way.
cat > hand/CMakeLists.txt << 'TXT'
cmake_minimum_required(VERSION 3.16)
project(hand CXX)
find_package(OROCOS-RTT REQUIRED)
include(${OROCOS-RTT_USE_FILE_PATH}/UseOROCOS-RTT.cmake)
orocos_use_package(Arm-kit REQUIRED)
orocos_library(hand hand.cpp EXPORT own INCLUDES DESTINATION include/orocos)
install(EXPORT own NAMESPACE own:: DESTINATION share/hand)
orocos_generate_package(NO_CMAKE_CONFIG)
TXT
rm -rf b3 inst3
build_package hand b3 inst3 -DCMAKE_PREFIX_PATH="$prefix;$work/moved"
expect_text inst3/share/hand/own.cmake 'add_library(own::hand SHARED IMPORTED)'
[ ! -e inst3/lib/cmake/hand ] || fail "a config that was not wanted"

# With several configurations in one build folder.
rm -rf b3 inst3
sed -i '/EXPORT own/d; s/ NO_CMAKE_CONFIG//' hand/CMakeLists.txt
echo 'orocos_library(hand hand.cpp)
orocos_generate_package()' >> hand/CMakeLists.txt
sed -i '0,/orocos_generate_package/{/orocos_generate_package/d}' hand/CMakeLists.txt
cmake -S hand -B b3 -G "Ninja Multi-Config" -DCMAKE_PREFIX_PATH="$prefix;$work/moved" > b3.log 2>&1 &&
  cmake --build b3 --config Debug > b3.log 2>&1 && cmake --install b3 --config Debug --prefix inst3 > b3.log 2>&1 || { cat b3.log; fail "Ninja Multi-Config"; }
cmake -S user -B b4 -DCMAKE_PREFIX_PATH="$prefix;$work/moved;$work/inst3" > b4.log 2>&1 && cmake --build b4 --clean-first > b4.log 2>&1 || { cat b4.log; fail "a package of one configuration"; }

# What a library hands on of other packages, through interfaces that are not installed and go in circles. A package that
# cannot be found by the name of its targets has to be found before.
mkdir foreign asks
printf '#include <arm/parts.hpp>\nint foreign() { return PARTS; }\n' > foreign/foreign.cpp
mkdir -p parts/lib/cmake/parts-of-arms parts/include/arm
echo '#define PARTS 0' > parts/include/arm/parts.hpp
cat > parts/lib/cmake/parts-of-arms/parts-of-arms-config.cmake << 'TXT'
add_library(parts::headers INTERFACE IMPORTED)
set_target_properties(parts::headers PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${CMAKE_CURRENT_LIST_DIR}/../../../include)
TXT
cat > foreign/CMakeLists.txt << 'TXT'
cmake_minimum_required(VERSION 3.16)
project(foreign CXX)
find_package(OROCOS-RTT REQUIRED)
include(${OROCOS-RTT_USE_FILE_PATH}/UseOROCOS-RTT.cmake)
find_package(Boost REQUIRED COMPONENTS program_options)
find_package(parts-of-arms REQUIRED)
add_library(one INTERFACE)
add_library(other INTERFACE)
target_link_libraries(one INTERFACE other Boost::program_options)
target_link_libraries(other INTERFACE one parts::headers)
orocos_library(foreign foreign.cpp)
target_link_libraries(foreign PUBLIC one $<$<CONFIG:Debug>:m> PRIVATE dl)
orocos_library(foreign-static STATIC foreign.cpp)
target_link_libraries(foreign-static PRIVATE foreign one)
orocos_generate_package()
TXT
build_package foreign b5 inst5 -DCMAKE_PREFIX_PATH="$prefix;$work/parts"
asks() { # line before the search
  printf 'cmake_minimum_required(VERSION 3.16)\nproject(asks CXX)\n%s\nfind_package(foreign REQUIRED)\nadd_executable(asks main.cpp)\ntarget_link_libraries(asks foreign::%s)\n' "$1" "$2" > asks/CMakeLists.txt
  cmake -S asks -B b6 -DCMAKE_PREFIX_PATH="$prefix;$work/parts;$work/inst5" > b6.log 2>&1 && cmake --build b6 > b6.log 2>&1
}
printf '#include <arm/parts.hpp>\n#include <boost/program_options.hpp>\nint foreign();\nint main() { boost::program_options::options_description all; return PARTS + foreign(); }\n' > asks/main.cpp
! asks '' foreign || fail "a target was found by no name"
tr -s ' \n' ' ' < b6.log > b6.line
expect_text b6.line 'the target parts::headers, which the libraries of foreign are linked to, was not found; find the package that has it before foreign'
asks 'find_package(parts-of-arms REQUIRED)' foreign || { cat b6.log; fail "what a library hands on"; }
b6/asks || fail "a program that is handed on libraries"
echo 'int foreign(); int main() { return foreign(); }' > asks/main.cpp
asks 'find_package(parts-of-arms REQUIRED)' foreign-static || { cat b6.log; fail "what a static library needs"; }

# An installation that has lost a file.
rm "$work"/moved/lib/libarm-archive-gnulinux.a
plain 'Arm-kit REQUIRED'
! configure_plain || fail "an incomplete package was found"
tr -s ' \n' ' ' < b2.log > b2.line
expect_text b2.line "its installation is not complete, there is no $work/moved/lib/libarm-archive-gnulinux.a"
