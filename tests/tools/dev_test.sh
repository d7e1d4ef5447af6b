#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# What the front door and CI say without building anything. Argument: the source tree.
set -uo pipefail
source=$1
failed=0

# expect TEXT STATUS COMMAND…: the command ends with STATUS and prints TEXT somewhere
expect() {
  local text=$1 status=$2 out found=0
  shift 2
  out=$("$@" 2>&1) || found=$?
  if [ "$found" != "$status" ]; then
    echo "$*: status $found, expected $status"; failed=1
  fi
  case $out in
    *"$text"*) ;;
    *) echo "$*: expected to print '$text', found: $out"; failed=1 ;;
  esac
}

expect "usage: ./dev VERB" 0 "$source/dev"
expect "usage: ./dev VERB" 0 "$source/dev" help
expect "unknown verb 'biuld'" 2 "$source/dev" biuld
expect "usage: ./dev VERB" 2 "$source/dev" biuld
expect "install wants one argument" 1 "$source/dev" install
expect "UPDATE_GOLDENS is set" 2 env UPDATE_GOLDENS=1 "$source/.ci/run"
expect "CI is set" 2 env CI=true "$source/tools/update_goldens.sh"

# A relative prefix is meant from where the user stands. Programs that would build or install are stand-ins.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/bin" "$work/here" "$work/copy/tools"
cp "$source/dev" "$work/copy"
cp "$source/tools/packages.txt" "$work/copy/tools"
printf '#!/bin/sh\necho "$@" >> %s/cmake.log\n' "$work" > "$work/bin/cmake"
printf '#!/bin/sh\nprintf installed\n' > "$work/bin/dpkg-query"
chmod +x "$work"/bin/*
(cd "$work/here" && PATH=$work/bin:$PATH "$work/copy/dev" install out > /dev/null 2>&1)
grep -q -- "--prefix $work/here/out\$" "$work/cmake.log" || { echo "install out: $(cat "$work/cmake.log")"; failed=1; }
# It installs what any other verb has built, and does not configure the tests away.
grep -q -- "--preset dev" "$work/cmake.log" || { echo "install does not use build/dev: $(cat "$work/cmake.log")"; failed=1; }
! grep -q OROFORGE_BUILD_TESTS "$work/cmake.log" || { echo "install changes whether tests are built"; failed=1; }

# A verb installs what it needs and no more: nothing of the tests for the demo. Nothing is installed on this machine.
printf '#!/bin/sh\nexit 0\n' > "$work/bin/dpkg-query"
printf '#!/bin/sh\necho "$0 $@"\n' > "$work/bin/apt-get"
cp "$work/bin/apt-get" "$work/bin/apt-cache"
printf '#!/bin/sh\n[ "$1" = env ] && shift && shift\n"$@"\n' > "$work/bin/sudo"
chmod +x "$work"/bin/*
needs() { PATH=$work/bin:$PATH "$work/copy/dev" setup "$@" 2>&1 | grep '^== installing'; }
[[ $(needs) = *libcli11-dev* && $(needs) != *gtest* && $(needs) != *benchmark* ]] || { echo "demo wants: $(needs)"; failed=1; }
[[ $(needs tests) = *libcli11-dev*libgtest-dev* && $(needs tests) != *lintian* ]] || { echo "tests want: $(needs tests)"; failed=1; }

for script in "$source/dev" "$source/.ci/run" "$source"/tools/*.sh "$source"/examples/*/run; do
  expect "" 0 bash -n "$script"
done

# Every verb the help names exists, and the other way round.
for verb in $("$source/dev" help | sed -n 's/^  \([a-z]*\) .*/\1/p' | grep -v help); do
  grep -q "^verb_$verb()" "$source/dev" || { echo "help names '$verb', which does not exist"; failed=1; }
done
for verb in $(sed -n 's/^verb_\([a-z]*\)().*/\1/p' "$source/dev"); do
  "$source/dev" help | grep -q "^  $verb " || { echo "verb '$verb' is not in the help"; failed=1; }
done
exit "$failed"
