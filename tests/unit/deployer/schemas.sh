#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# The schemas and the DTD that are installed, on files that the deployer takes and refuses.
#   usage: schemas.sh SOURCE_DIR
set -euo pipefail
cd "$1"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { echo "error: $*" >&2; exit 1; }

of_schema() { xmllint --noout --nonet --schema "share/$1.xsd" "$2" > "$folder/said" 2>&1; }
of_dtd() { xmllint --noout --nonet --dtdvalid share/cpf.dtd "$1" > "$folder/said" 2>&1; }
takes() { "$@" || fail "$* is refused: $(cat "$folder/said")"; }
refuses() { ! "$@" || fail "$* is taken"; }

deployments=(examples/*/*.xml tests/golden/{component,package}/*/expected/files/*/deploy/*.xml)
count=0
for file in "${deployments[@]}"; do
  grep -q '<properties' "$file" || continue
  takes of_schema deployment "$file"
  takes of_dtd "$file"
  count=$((count + 1))
done
[ "$count" -ge 8 ] || fail "only $count deployment files were found"
for file in examples/*/*.cpf tests/unit/manual/files/*.cpf; do
  takes of_schema cpf "$file"
  takes of_dtd "$file"
done

file=$folder/wrong.xml
for wrong in '<things/>' '<properties>text</properties>' '<properties><simple name="a"><value>1</value></simple></properties>' \
  '<properties><struct name="s"><simple name="a" type="long">1</simple></struct></properties>' \
  '<properties><struct name="s"><other/></struct></properties>'; do
  echo "$wrong" > "$file"
  refuses of_schema cpf "$file"
  refuses of_schema deployment "$file"
  refuses of_dtd "$file"
done
for wrong in '<simple name="Imprt" type="string"><value>ocl</value></simple>' '<struct name="a"/>' '<struct type="t"/>' \
  '<simple name="Import" type="string"><value/></simple>' '<struct name="" type="t"/>' \
  '<struct name="a" type="t"><simple name="AutoConf" type="real"><value>1</value></simple></struct>'; do
  echo "<properties>$wrong</properties>" > "$file"
  refuses of_schema deployment "$file"
done
