#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# load_all.sh DEPLOYER PATH PACKAGE…: imports the typekits, and makes a value of each message.
set -euo pipefail
deployer=$1
export RTT_COMPONENT_PATH=$2 ORO_LOGFILE=/dev/null
shift 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
number=0
for package in "$@"; do
  echo "import(\"rtt_$package\")"
  for file in "/usr/share/$package/msg/"*.msg; do
    name=$(basename "$file" .msg)
    number=$((number + 1))
    echo "var $package.$name v$number"
    echo "var $package.$name[] a$number = $package.$name[](2)"
  done
done > "$work/all.ops"
"$deployer" < "$work/all.ops" > "$work/out" 2>&1 || { cat "$work/out"; exit 1; }
! grep -E ': (error|warning): ' "$work/out" || exit 1
[ "$number" -gt 0 ]
