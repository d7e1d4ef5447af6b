#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Editing a header, or one it includes, or the manifest, generates anew, once; a build without an edit does nothing.
source "$(dirname "$0")/package_test.sh"
cd "$work"

expect_idle() { # what
  local stamp
  stamp=$(find b/orocos -name '*.so' -exec stat -c %Y.%y {} +)
  cmake --build b > again.log 2>&1 || { cat again.log; fail "$generator: build $1"; }
  ! grep Generating again.log || fail "$generator: a build $1 ran a generator"
  [ "$stamp" = "$(find b/orocos -name '*.so' -exec stat -c %Y.%y {} +)" ] || fail "$generator: a build $1 linked again"
}
rebuild() { # what
  cmake --build b > again.log 2>&1 || { cat again.log; fail "$generator: build after $1"; }
}

cat > edit.xml << 'XML'
<?xml version="1.0" encoding="UTF-8"?>
<package name="edit">
  <typekit header="include/edit/edit-types.hpp"/>
  <typekit header="src/more-types.hpp"/>
  <component class="edit::One"/>
</package>
XML
mkdir -p include/edit
printf '#pragma once\nstruct Inner { int a; };\n' > include/edit/inner.hpp
printf '#pragma once\n#include "inner.hpp"\nstruct Outer { Inner inner; };\n' > include/edit/edit-types.hpp
mkdir src
printf '#pragma once\nstruct More { int a; };\n' > src/more-types.hpp
for generator in "Unix Makefiles" Ninja; do
  rm -rf edit b
  orocreate-pkg edit --from edit.xml > /dev/null
  cp include/edit/inner.hpp edit/include/edit
  build_package edit b "$work/inst" -G "$generator" -DBUILD_TESTING=OFF -DCMAKE_BUILD_TYPE=Debug
  ! grep -rq '"added"' b/typekit || fail "a field is there before it was added"
  expect_idle "without an edit"
  sleep 1
  printf '#pragma once\nstruct Inner { int a; double added; };\n' > edit/include/edit/inner.hpp
  rebuild "the edit of an included header"
  grep -rq '"added"' b/typekit || fail "$generator: the field of an included header is missing"
  expect_idle "after the edit of an included header"
  sleep 1
  touch edit/edit.xml edit/include/edit/edit-types.hpp
  rebuild "a touch"
  grep -q 'Generating typekit' again.log || fail "$generator: touching the header had no effect"
  expect_idle "after a touch"
  for folder in typekit generated; do
    file=$(find b/$folder -name '*.hpp' | sort | head -n 1)
    rm "$file"
    rebuild "the removal of $file"
    expect_file "$file"
    expect_idle "after the removal of $file"
  done
done
