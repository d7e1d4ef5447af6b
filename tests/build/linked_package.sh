#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Programs that are made of components, of loaded, linked and static libraries; plugins written by hand.
source "$(dirname "$0")/package_test.sh"
here=$(cd "$(dirname "$0")" && pwd)
export ORO_LOGFILE=/dev/null

cp -r "$here/packages/linked" "$here/packages/linking" "$work"
build_package "$work/linked" "$work/b1" "$work/inst" -DCMAKE_CXX_FLAGS="-Wall -Wextra -Werror"
expect_file "$work/inst/lib/liblinked-static-gnulinux.a"
runs() { # status output program argument…
  local status=0 wanted=$1 text=$2
  shift 2
  "$@" > "$work/run.out" 2>&1 || status=$?
  [ "$status" = "$wanted" ] || { cat "$work/run.out" >&2; fail "$* ended with status $status, not $wanted"; }
  expect_text "$work/run.out" "$text"
}
holds_no_static_components() { # file
  expect_file "$1"
  ! grep -qF linked::One "$1" || fail "$1 holds the static components"
}
grep -qF linked::One "$work/b1/bare" || fail "the name of a static component is no text of the program"
holds_no_static_components "$work/inst/lib/orocos/gnulinux/linked/liblinked-user-gnulinux.so"
runs 0 two "$work/b1/bare"
runs 0 'created 6' "$work/inst/bin/linked-main-gnulinux"
runs 7 'argc 3, last word' "$work/inst/bin/linked-c-gnulinux" a word
export RTT_COMPONENT_PATH="/nowhere;$work/inst/lib/orocos:$work/inst/lib/orocos"
runs 0 'started: 42, hello' "$work/inst/bin/started"
deploy_until 'shared: 42, hello' -s "$work/linked/app.xml"

PKG_CONFIG_PATH=$work/inst/lib/pkgconfig build_package "$work/linking" "$work/b2" "$work/inst2"
runs 0 111 "$work/inst2/bin/linking-gnulinux"
holds_no_static_components "$work/inst2/lib/orocos/gnulinux/linking/liblinking-other-gnulinux.so"
