#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# The demo: its numbers with the usual reader, and with another rate, an added field and a reader that is too slow.
set -euo pipefail
prefix=$1 example=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { cat "$work/out" >&2; echo "FAILED: $*" >&2; exit 1; }
number() { sed -n "s/.*verdict: .*$1 \([0-9]*\).*/\1/p" "$work/out"; }

"$example/run" "$prefix" --seconds 1 > "$work/out" 2>&1 || fail "the demo ended with status $?"
[ "$(number sent)" = 100 ] && [ "$(number received)" = 100 ] && [ "$(number lost)" = 0 ] || fail "100 samples expected, none lost"
while IFS= read -r line; do
  grep -qF -- "$line" "$work/out" || fail "expected output '$line' is missing"
done < "$example/expected_output.txt"

"$example/run" "$prefix" --rate 200 --seconds 1 --slow-reader --field pressure=1.25 > "$work/out" 2>&1 || fail "the slow reader ended with status $?"
sent=$(number sent) received=$(number received) lost=$(number lost)
[ "$sent" = 200 ] || fail "200 samples expected, $sent sent"
[ "$lost" -gt 100 ] && [ $((received + lost)) = "$sent" ] || fail "received $received and lost $lost do not fit sent $sent"
grep -q 'pressure = 1.25' "$work/out" || fail "the added field does not arrive"

! "$example/run" "$prefix" --rate fast > "$work/out" 2>&1 || fail "a wrong rate was accepted"
! "$example/run" "$work" > "$work/out" 2>&1 || fail "a prefix without toolchain was accepted"
