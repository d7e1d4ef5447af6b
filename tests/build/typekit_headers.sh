#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Wherever a header of a typekit lies and whatever options its package compiles with, typegen sees it as the compiler
# does, and other packages can use it, with nothing but orocos_typegen_headers().
source "$(dirname "$0")/package_test.sh"
here=$(cd "$(dirname "$0")" && pwd)

cp -r "$here/packages/places" "$here/packages/depends" "$work"
for generator in Ninja "Unix Makefiles"; do
  rm -rf "$work/b" "$work/inst"
  build_package "$work/places" "$work/b" "$work/inst" -G "$generator" -DCMAKE_CXX_FLAGS="-Wall -Wextra -Werror"
done
headers=$work/inst/include/orocos
for file in places/places-types.hpp places/root-types.hpp places/models/States.hpp places/folder/sub.hpp places/typekit/Types.hpp; do
  expect_file "$headers/$file"
done
[ "$(ls "$headers")" = places ] || fail "headers outside the package's folder"

# A header that is added to a listed folder belongs to the typekit from the next build on.
printf '#pragma once\nnamespace places { struct Late { int late; }; }\n' > "$work/places/src/folder/late.hpp"
cmake --build "$work/b" > "$work/b.log" 2>&1 || { cat "$work/b.log"; fail "build with a new header"; }
grep -rq '"late"' "$work/b/typekit" || fail "a header that was added to a folder went unnoticed"

# Another package finds the typekit by CMAKE_PREFIX_PATH, and needs no more than DEPENDS.
build_package "$work/depends" "$work/b2" "$work/inst2" -DCMAKE_PREFIX_PATH="$prefix;$work/inst" -DCMAKE_CXX_FLAGS="-Wall -Wextra -Werror"
expect_text "$work/inst2/lib/pkgconfig/depends-typekit-gnulinux.pc" places-gnulinux

# Attributes of the headers are no unknown ones, neither to the targets above, compiled with -Werror, nor by pkg-config.
export PKG_CONFIG_PATH=$work/inst/lib/pkgconfig:$prefix/lib/pkgconfig
silent() { # compiler option of pkg-config…
  # shellcheck disable=SC2046  # several words
  "$1" -std=c++17 -Wall -Wextra -Werror -fsyntax-only -x c++ - $(pkg-config "${@:2}" --cflags places-typekit-gnulinux) <<< '#include <places/root-types.hpp>' ||
    fail "$1 warns of attributes"
}
silent g++
if command -v clang++-19 > /dev/null; then
  silent clang++-19 --define-variable=attributes=-Wno-unknown-attributes
  rm -rf "$work/b2" "$work/inst2"
  build_package "$work/depends" "$work/b2" "$work/inst2" -DCMAKE_PREFIX_PATH="$prefix;$work/inst" -DCMAKE_CXX_COMPILER=clang++-19 \
    -DCMAKE_CXX_FLAGS="-Wall -Wextra -Werror"
fi

# From the command line typegen finds the headers of the moved installation that it is of.
printf '#pragma once\n#include <rtt/ConnPolicy.hpp>\nstruct Plain { double value; };\n' > "$work/plain.hpp"
(cd "$work" && env -u PKG_CONFIG_PATH typegen -o plain plain plain.hpp) || fail "typegen does not find its own <rtt/…>"

# Where both packages are moved, the typekit finds the one that it is linked with by RTT_COMPONENT_PATH alone.
cp -r "$work/inst" "$work/moved1"
cp -r "$work/inst2" "$work/moved2"
rm -rf "$work/inst" "$work/inst2"
printf 'import("depends")\n' > "$work/moved.ops"
(cd "$work" && RTT_COMPONENT_PATH=$work/moved2/lib/orocos:$work/moved1/lib/orocos timeout 60 rttscript -s moved.ops > moved.out 2>&1) ||
  { cat "$work/moved.out" >&2; fail "a typekit that is linked with one in another, moved prefix is not loaded"; }
! (cd "$work" && RTT_COMPONENT_PATH=$work/moved2/lib/orocos timeout 60 rttscript -s moved.ops > moved.out 2>&1) ||
  fail "a typekit is loaded without the one that it needs"
expect_text "$work/moved.out" "it needs libplaces-"
