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
