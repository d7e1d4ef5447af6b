#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# What orocreate-pkg scaffolds builds with plain cmake against the moved installation, without a warning.
source "$(dirname "$0")/package_test.sh"
cd "$work"

orocreate-pkg mypkg component typekit
build_package mypkg b1 "$work/inst" -DCMAKE_CXX_FLAGS="-Wall -Wextra -Wconversion -Werror"
expect_file inst/lib/orocos/gnulinux/mypkg/libmypkg-gnulinux.so
expect_file inst/lib/orocos/gnulinux/mypkg/types/libmypkg-typekit-gnulinux.so
# Each test is one of ctest's.
ctest --test-dir b1 > tests.log || { cat tests.log; fail "the tests of the package"; }
for name in CanBeMade RunsStepByStep; do expect_text tests.log "mypkg-test.Mypkg.$name"; done
[ ! -e b1/orocos.log ] || ! grep -i error b1/orocos.log || fail "listing or running tests logs errors"
cat > app.xml <<'TXT'
<?xml version="1.0" encoding="UTF-8"?>
<properties>
  <simple name="Import" type="string"><value>mypkg</value></simple>
  <struct name="one" type="Mypkg">
    <simple name="AutoConf" type="boolean"><value>1</value></simple>
    <simple name="AutoStart" type="boolean"><value>1</value></simple>
  </struct>
</properties>
TXT
export RTT_COMPONENT_PATH=$work/inst/lib/orocos
deploy_until 'Mypkg' -s app.xml

# As colcon's setup files have it: each hook that colcon.pkg lists puts the package into RTT_COMPONENT_PATH, once.
hooks=$(/usr/bin/python3 -c 'import json; print(*json.load(open("mypkg/colcon.pkg"))["hooks"])')
for hook in $hooks; do
  case $hook in
    *.dsv) IFS=';' read -r action name value < "inst/$hook"
      [ "$action $name $value" = "prepend-non-duplicate RTT_COMPONENT_PATH lib/orocos" ] || fail "$hook: $action $name $value" ;;
    *.sh) (
      _colcon_prepend_unique_value() { [ "$1 $2" = "RTT_COMPONENT_PATH $work/inst/lib/orocos" ] || fail "$hook: $*"; }
      COLCON_CURRENT_PREFIX=$work/inst
      . "inst/$hook") ;;
    *) fail "hook $hook" ;;
  esac
done
[ "$(wc -w <<< "$hooks")" = 2 ] || fail "hooks of colcon.pkg: $hooks"

# By a preset; what builds write is nothing to commit, and editors know how files are compiled.
mypkg_git() { ! command -v git > /dev/null || git -C mypkg "$@"; }
mypkg_git init -q
mypkg_git add .
(cd mypkg && cmake --preset debug -DCMAKE_PREFIX_PATH="$prefix" -DBUILD_TESTING=OFF) > b2.log 2>&1 || { cat b2.log; fail "configuring by a preset"; }
[ -z "$(mypkg_git status --porcelain | grep -v '^A ')" ] || fail "a build writes what git does not ignore"
expect_text mypkg/build/debug/compile_commands.json src/mypkg-component.cpp
! grep test_main.cpp mypkg/build/debug/compile_commands.json || fail "tests are built with BUILD_TESTING=OFF"

# A type that cannot be supported stops the build with a located message and leaves nothing half-written.
printf 'struct Broken { int* pointer; };\n' >> mypkg/include/mypkg/mypkg-types.hpp
b2=mypkg/build/debug
! cmake --build $b2 > b2.log 2>&1 || fail "a pointer member was accepted"
grep -qE 'mypkg-types.hpp:[0-9]+:[0-9]+: error: \[TK[0-9]+\]' b2.log || { cat b2.log; fail "no located message"; }
[ -z "$(find $b2/typekit -name '*.cpp' 2> /dev/null)" ] || fail "half a typekit was left behind"
