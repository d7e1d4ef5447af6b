#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# A package that commits what typegen wrote: built without typegen, checked for being current where there is one, and
# loaded from the build tree.
source "$(dirname "$0")/package_test.sh"
package=$work/keeper
mkdir -p "$package/include/keeper"
header=$package/include/keeper/keeper-types.hpp
cat > "$package/CMakeLists.txt" << 'TXT'
cmake_minimum_required(VERSION 3.16)
project(keeper LANGUAGES CXX)
find_package(OROCOS-RTT REQUIRED)
include(${OROCOS-RTT_USE_FILE_PATH}/UseOROCOS-RTT.cmake)
enable_testing()
orocos_typegen_headers(include/keeper/keeper-types.hpp COMMITTED generated)
orocos_component(keeper-user user.cpp)
orocos_generate_package()
TXT
cat > "$package/user.cpp" << 'TXT'
#include <rtt/Component.hpp>
#include <rtt/TaskContext.hpp>
#include <keeper/typekit/Types.hpp>
#include <iostream>
struct User : RTT::TaskContext {
    explicit User(const std::string& name) : TaskContext(name) {
        addProperty("value", value_);
        addOperation("show", &User::show, this);
    }
    void show() { std::cout << "kept " << value_.x << std::endl; }
    keeper::Value value_;
};
ORO_CREATE_COMPONENT(User)
TXT
cat > "$work/app.ops" << 'TXT'
import("keeper")
loadComponent("user", "User")
var keeper.Value v
v.x = 41
user.value = v
user.value.x = user.value.x + 1
user.show()
TXT
printf '#pragma once\nnamespace keeper { struct Value { int x = 0; }; }\n' > "$header"
in_build() { cmake --build "$work/b" --parallel 2 "$@" > "$work/b.log" 2>&1 || { cat "$work/b.log" >&2; fail "build $*"; }; }

# The first time there is nothing yet: the typekit is generated into the build folder, as without COMMITTED.
build_package "$package" "$work/b" "$work/inst" -G Ninja
[ ! -e "$package/generated" ] || fail "a build wrote into the source folder"
in_build --target keeper-typekit-refresh
expect_file "$package/generated/Plugin.cpp"
expect_file "$package/generated/types/keeper/typekit/Types.hpp"
! grep -rF "$work" "$package/generated" || fail "committed files name this machine"
rm -rf "$work/b/typekit"
in_build
[ ! -e "$work/b/typekit/Plugin.cpp" ] || fail "what is committed was generated anew"

# A test of the package tells whether the files are current.
check() { (cd "$work/b" && ctest --output-on-failure > ctest.log 2>&1); }
check || { cat "$work/b/ctest.log"; fail "fresh files are said to be stale"; }
printf '#pragma once\nnamespace keeper { struct Value { int x = 0; double added = 0; }; }\n' > "$header"
before=$(find "$package" -type f -exec stat -c '%n %y' {} + | sort)
! check || fail "nobody noticed that the files are stale"
expect_text "$work/b/ctest.log" '[TK067] stale: typegen now writes'
expect_text "$work/b/ctest.log" "to refresh: cmake --build $work/b --target keeper-typekit-refresh"
[ "$before" = "$(find "$package" -type f -exec stat -c '%n %y' {} + | sort)" ] || fail "the check wrote into the package"
rm "$package/generated/Plugin.cpp"
! check || fail "nobody noticed that a file is missing"
expect_text "$work/b/ctest.log" 'Plugin.cpp: error: [TK067] missing'
in_build --target keeper-typekit-refresh
check || { cat "$work/b/ctest.log"; fail "refreshed files are said to be stale"; }

# The same toolchain without typegen, as it is installed where there is no LLVM.
cp -rl "$prefix" "$work/bare"
rm "$work/bare/bin/typegen"
prefix=$work/bare
export PATH=$work/bare/bin:${PATH#*:}
! command -v typegen || fail "typegen is still found"
for generator in Ninja "Unix Makefiles"; do
  rm -rf "$work/b"
  build_package "$package" "$work/b" "$work/inst" -G "$generator"
  ! grep -rIq typegen "$work/b" --include='*.make' --include=build.ninja --include=Makefile || fail "$generator: the build asks for typegen"
done
expect_file "$work/inst/include/orocos/keeper/typekit/Types.hpp"
expect_file "$work/inst/lib/orocos/gnulinux/keeper/types/libkeeper-typekit-gnulinux.so"

# Its build tree is loadable as it is, and so is the installation.
rm -rf "$work/elsewhere"
mv "$work/inst" "$work/elsewhere"
RTT_COMPONENT_PATH=$work/b/orocos deploy_until 'kept 42' -s "$work/app.ops"
RTT_COMPONENT_PATH=$work/elsewhere/lib/orocos deploy_until 'kept 42' -s "$work/app.ops"

# Neither files nor a typegen to make them.
rm -r "$package/generated"
! cmake -S "$package" -B "$work/b2" -DCMAKE_PREFIX_PATH="$prefix" > "$work/b2.log" 2>&1 || fail "configured without any source"
tr -s ' \n' ' ' < "$work/b2.log" > "$work/b2.line"
expect_text "$work/b2.line" "no generated sources in $package/generated, and no program typegen"
