#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Editing a header, or one it includes, regenerates the typekit; a second build does nothing.
source "$(dirname "$0")/package_test.sh"
cd "$work"

for generator in "Unix Makefiles" Ninja; do
  rm -rf edit b
  orocreate-pkg edit typekit
  printf '#pragma once\nstruct Inner { int a; };\n' > edit/include/edit/inner.hpp
  printf '#pragma once\n#include "inner.hpp"\nstruct Outer { Inner inner; };\n' > edit/include/edit/edit-types.hpp
  build_package edit b "$work/inst" -G "$generator"
  ! grep -rq '"added"' b/typekit || fail "a field is there before it was added"
  stamp=$(find b/orocos -name '*typekit*.so' -exec stat -c %Y.%y {} +)
  cmake --build b > again.log 2>&1
  [ "$stamp" = "$(find b/orocos -name '*typekit*.so' -exec stat -c %Y.%y {} +)" ] || fail "$generator: a second build linked again"
  sleep 1
  printf '#pragma once\nstruct Inner { int a; double added; };\n' > edit/include/edit/inner.hpp
  cmake --build b > again.log 2>&1 || { cat again.log; fail "$generator: build after the edit"; }
  grep -rq '"added"' b/typekit || fail "$generator: the field of an included header is missing"
done
