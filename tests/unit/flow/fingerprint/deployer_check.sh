#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# deployer_check.sh DEPLOYER LIBRARIES TARGET: `deployer --check` finds ports whose plugins see their type differently.
set -u
deployer=$1 libraries=$2 target=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

# check READER: a connection of the first version's writer with that version's reader
check() {
  cat > deploy.xml << XML
<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE properties SYSTEM "cpf.dtd">
<properties>
  <simple name="Import" type="string"><value>$libraries/libfingerprint_first-$target.so</value></simple>
  <simple name="Import" type="string"><value>$libraries/libfingerprint_$1-$target.so</value></simple>
  <struct name="w" type="Writer_first">
    <struct name="Ports" type="PropertyBag"><simple name="out" type="string"><value>wire</value></simple></struct>
  </struct>
  <struct name="r" type="Reader_$1">
    <struct name="Ports" type="PropertyBag"><simple name="in" type="string"><value>wire</value></simple></struct>
  </struct>
</properties>
XML
  "$deployer" --check -s deploy.xml > "$1.log" 2>&1
}
fail() {
  echo "$1" >&2
  cat ./*.log >&2
  exit 1
}

check same || fail "plugins built alike are refused"
check swapped && fail "plugins built differently are accepted"
grep -q "deploy.xml:10:.*error: \[DEP044\] port 'r.in' cannot take part in connection 'wire'" swapped.log || fail "no error at the port"
grep -q "field 'path\[\].second.x' is at byte 0 in the plugin of w.out, byte 8 in that of r.in" swapped.log || fail "no field is named"
