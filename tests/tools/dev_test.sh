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
