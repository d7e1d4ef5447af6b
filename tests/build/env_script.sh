#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# env.sh of an installation, wherever that was moved to, in the shells that are here; a user's first steps by it alone.
source "$(dirname "$0")/package_test.sh"
export PATH=${PATH#"$prefix/bin:"}
moved="$work/a tool chain"
cp -r --reflink=auto "$prefix" "$moved"
mkdir -p "$moved/share/lua/5.1"
clean() { env -u RTT_COMPONENT_PATH -u CMAKE_PREFIX_PATH -u PKG_CONFIG_PATH -u LUA_PATH -u OROCOS_TARGET -u OROFORGE_PREFIX "$@"; }
cd /

tried=""
for shell in sh bash "bash --posix" dash zsh ksh mksh yash "busybox sh"; do
  command -v "${shell% *}" > /dev/null || continue
  tried+=" ${shell% *}"
  # shellcheck disable=SC2016,SC2086  # expanded by that shell; a shell may be two words
  clean $shell -c 'set -eu; . "$1/env.sh"; . "$1/env.sh"; printf "%s\n" "$PATH" "$CMAKE_PREFIX_PATH" "$PKG_CONFIG_PATH" "$RTT_COMPONENT_PATH" "$LUA_PATH" "$OROCOS_TARGET"; command -v typegen; set | grep -i ^_oroforge || true' x "$moved" > "$work/out" 2>&1 ||
    { cat "$work/out"; fail "$shell"; }
  printf '%s\n' "$moved/bin:$PATH" "$moved" "$moved/lib/pkgconfig" "$moved/lib/orocos" "$moved/share/lua/5.1/?.lua;;" gnulinux "$moved/bin/typegen" |
    diff - <(tr -d "'" < "$work/out") || fail "what $shell has of env.sh"
  # Run instead of read: one line tells. A script of the same name that reads it is something else.
  # shellcheck disable=SC2086
  clean $shell "$moved/env.sh" > "$work/out" 2>&1 || { cat "$work/out"; fail "$shell runs env.sh"; }
  [ "$shell" = zsh ] || expect_text "$work/out" "this changes nothing, because it was run; have the shell read it: . $moved/env.sh"
  mkdir -p "$work/mine"
  echo ". '$moved/env.sh'" > "$work/mine/env.sh"
  # shellcheck disable=SC2086
  clean $shell "$work/mine/env.sh" > "$work/out" 2>&1 || { cat "$work/out"; fail "$shell runs a script that reads env.sh"; }
  ! grep . "$work/out" || fail "$shell is told that it ran env.sh"
  # In a sub-shell, by a relative name, in front of what is there already, and behind a link.
  ln -sfn "$moved" "$work/link"
  # shellcheck disable=SC2016,SC2086
  clean CMAKE_PREFIX_PATH=/mine LUA_PATH='/lua/?.lua' $shell -c 'cd "$1"; (. ./env.sh; printf "%s\n" "$CMAKE_PREFIX_PATH" "$LUA_PATH"); printf "%s\n" "$CMAKE_PREFIX_PATH"' x "$work/link" > "$work/out" 2>&1
  grep -qE "^($moved|$work/link):/mine\$" "$work/out" && grep -qF "share/lua/5.1/?.lua;/lua/?.lua" "$work/out" && [ "$(tail -n 1 "$work/out")" = /mine ] ||
    { cat "$work/out"; fail "$shell in a sub-shell"; }
done
case $tried in *bash*dash*) ;; *) fail "tried only:$tried" ;; esac
echo "tried:$tried"

# A file that was taken away from its toolchain says so.
mkdir "$work/alone"
cp "$moved/env.sh" "$work/alone"
! clean bash -c '. "$1"' x "$work/alone/env.sh" > "$work/out" 2>&1 || fail "env.sh without a toolchain"
expect_text "$work/out" "there is no toolchain in '$work/alone'"
! clean dash -c '. "$1" || exit 3' x "$work/alone/env.sh" > "$work/out" 2>&1 || fail "env.sh without a toolchain, dash"
clean OROFORGE_PREFIX="$moved" dash -c '. "$1"; command -v typegen' x "$work/alone/env.sh" > "$work/out" 2>&1 || { cat "$work/out"; fail "OROFORGE_PREFIX"; }
expect_text "$work/out" "$moved/bin/typegen"

# Scaffold, build and deploy with nothing else set.
cat > "$work/steps" << 'TXT'
set -e
. "$1/env.sh"
cd "$2"
orocreate-pkg mypkg component typekit
cmake -S mypkg -B build -DCMAKE_INSTALL_PREFIX="$2/install"
cmake --build build --parallel 2 --target install
TXT
clean dash "$work/steps" "$moved" "$work" > "$work/steps.log" 2>&1 || { cat "$work/steps.log"; fail "a user's first steps"; }
cat > "$work/app.ops" << 'TXT'
import("mypkg")
loadComponent("one", "Mypkg")
one.configure()
one.start()
TXT
# shellcheck source=/dev/null
. "$moved/env.sh"
export RTT_COMPONENT_PATH=$work/install/lib/orocos:$RTT_COMPONENT_PATH
deploy_until 'Mypkg' -linfo -s "$work/app.ops"
